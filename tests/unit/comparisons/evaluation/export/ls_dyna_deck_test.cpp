#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "tests/unit/comparisons/evaluation/export/deck_cases.hpp"

namespace rebound {
namespace {

using namespace deck_tests;

// The long-term law and the branches beside it, as the code adds them: C₁₀ = μ∞/2, G = g μ₀.
TEST(LsDynaDeckTest, Numbers) {
  FemProblem problem = problem_of(ElasticModel::neo_hookean_isochoric);
  problem.plate.friction = 0.3;
  problem.gravity = 9.81;
  EXPECT_EQ(refused_key("ls-dyna", problem_of(ElasticModel::hyperfoam)), "model.material.elastic");
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 5e-4}};
  EXPECT_EQ(refused_key("ls-dyna", problem), "model.material.branch.relaxes");
  problem.material.branches[0].relaxes = Relaxes::deviator;
  const ExportedDeck deck = deck_for("ls-dyna", problem);
  std::istringstream law(deck.text.substr(deck.text.find("*MAT_HYPERELASTIC_RUBBER")));
  std::string line;
  std::getline(law, line);
  std::getline(law, line);
  // Long-term: K₀ = 16.667 MPa, μ∞ = 0.7 · 3.5714 MPa.
  const double shear = 0.7 * 10e6 / 2.8, bulk = 10e6 / 0.6;
  EXPECT_NEAR(std::stod(line.substr(20, 10)), (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)),
              1e-6);
  std::getline(law, line);
  EXPECT_NEAR(std::stod(line.substr(0, 10)), 0.5 * shear, 1.0);
  std::getline(law, line);
  EXPECT_NEAR(std::stod(line.substr(0, 10)), 0.3 * 10e6 / 2.8, 1.0);
  EXPECT_NEAR(std::stod(line.substr(10, 10)), 2000.0, 1e-6);
  EXPECT_EQ(deck.elements, 6 * static_cast<int>(mesh().cells.size()));
  EXPECT_EQ(count_of(deck.text, "*BOUNDARY_SPC_SET"), 3);
  EXPECT_NE(deck.text.find("       0.3         0\n*DEFINE_CURVE"), std::string::npos);
  problem.plate.friction = 1.0;
  EXPECT_EQ(refused_key("ls-dyna", problem), "model.plate.friction");
}

// Volume of the bricks: each is right side out, and the quarter is whole.
TEST(LsDynaDeckTest, BricksFillTheQuarter) {
  const std::string text = deck_for("ls-dyna", problem_of(ElasticModel::neo_hookean)).text;
  std::istringstream lines(text.substr(text.find("*NODE\n")));
  std::vector<std::array<double, 3>> nodes;
  double volume = 0.0;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line[0] != '*')
    nodes.push_back({std::stod(line.substr(8, 16)), std::stod(line.substr(24, 16)),
                     std::stod(line.substr(40, 16))});
  while (std::getline(lines, line) && line[0] != '*') {
    std::array<std::array<double, 3>, 8> p;
    for (int i = 0; i < 8; ++i) p[i] = nodes[std::stoi(line.substr(16 + 8 * i, 8)) - 1];
    const auto tetrahedron = [&](int a, int b, int c, int d) {
      double m[3][3];
      for (int i = 0; i < 3; ++i) {
        m[0][i] = p[b][i] - p[a][i];
        m[1][i] = p[c][i] - p[a][i];
        m[2][i] = p[d][i] - p[a][i];
      }
      return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
              m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])) /
             6.0;
    };
    const double brick = tetrahedron(0, 1, 3, 4) + tetrahedron(1, 2, 3, 6) +
                         tetrahedron(4, 6, 5, 1) + tetrahedron(4, 7, 6, 3) +
                         tetrahedron(1, 6, 3, 4);
    EXPECT_GT(brick, 0.0) << line;
    volume += brick;
  }
  EXPECT_NEAR(volume / (M_PI / 3.0 * std::pow(0.0331, 3)), 1.0, 0.07);  // chords
}

}  // namespace
}  // namespace rebound
