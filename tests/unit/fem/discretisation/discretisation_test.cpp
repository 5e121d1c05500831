#include "fem/discretisation/discretisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(DiscretisationTest, MassIsExactWhateverTheMesh) {
  const Mesh mesh = test::distorted_cylinder();
  const auto body = discretise(mesh, 0.0896);
  EXPECT_NEAR(std::accumulate(body.mass.begin(), body.mass.end(), 0.0), 0.0896, 1e-16);
  for (const double mass : body.mass) EXPECT_GT(mass, 0.0);
  EXPECT_NEAR(body.density, 0.0896 / (1.2 * std::numbers::pi), 1e-14);
  EXPECT_EQ(body.node_count(), static_cast<int>(mesh.vertices.size()));
  EXPECT_EQ(body.cells.size(), mesh.cells.size());
}

/// `mesh` with its vertices numbered anew at random.
Mesh shuffled(const Mesh& mesh) {
  std::vector<int> number(mesh.vertices.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937_64(41));
  Mesh other = mesh;
  for (std::size_t v = 0; v < number.size(); ++v)
    other.vertices[static_cast<std::size_t>(number[v])] = mesh.vertices[v];
  const auto renumber = [&](auto& of) {
    for (auto& each : of)
      for (int& vertex : each) vertex = number[static_cast<std::size_t>(vertex)];
  };
  renumber(other.cells);
  renumber(other.axis_edges);
  renumber(other.contact_edges);
  return other;
}

/// Distances in number at which nodes of a block have neighbours, a block.
double diagonals_of_a_block(const std::vector<std::array<int, nodes_per_cell>>& cells, int nodes) {
  std::set<std::array<int, 2>> diagonals;
  for (const auto& cell : cells)
    for (const int a : cell)
      for (const int b : cell)
        if (a != b) diagonals.insert({a / nodes_per_block, b - a});
  return static_cast<double>(nodes_per_block * diagonals.size()) / nodes;
}

TEST(DiscretisationTest, NodesAreNumberedForFewDiagonals) {
  const Mesh rows = generate_sphere_mesh({.radius = 0.0331, .cells = 1000});
  const Mesh at_random = shuffled(rows);
  const auto nodes = static_cast<int>(rows.vertices.size());
  const auto found = [&](const Mesh& mesh) {
    std::vector<std::array<int, nodes_per_cell>> cells;
    for (const CellGeometry& cell : discretise(mesh, 1.0).cells) cells.push_back(cell.nodes);
    return diagonals_of_a_block(cells, nodes);
  };
  EXPECT_EQ(found(rows),
            diagonals_of_a_block(rows.cells, nodes));  // row by row, as the mesh has it
  EXPECT_LT(found(rows), 10.0);                        // eight neighbours, and ends
  EXPECT_GT(diagonals_of_a_block(at_random.cells, nodes), 25.0);
  EXPECT_LT(found(at_random), 12.0);  // Cuthill and McKee's
}

TEST(DiscretisationTest, PointOrder) {
  // The kernels hold these three numbers; point q is the one nearest corner q.
  const double g = 1.0 / std::sqrt(3.0);
  const double near = 0.25 * (1 + g) * (1 + g), middle = 0.25 * (1 - g * g),
               far = 0.25 * (1 - g) * (1 - g);
  for (const auto& cell : discretise(test::distorted_cylinder(), 1.0).cells)
    for (int q = 0; q < points_per_cell; ++q) {
      EXPECT_NEAR(cell.shape[q][q], near, 1e-15);
      EXPECT_NEAR(cell.shape[q][(q + 1) % 4], middle, 1e-15);
      EXPECT_NEAR(cell.shape[q][(q + 2) % 4], far, 1e-15);
      EXPECT_NEAR(cell.shape[q][(q + 3) % 4], middle, 1e-15);
    }
}

TEST(DiscretisationTest, CellsRunCounterClockwise) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const auto& cell : body.cells)
    for (int i = 0; i < 4; ++i) {
      const auto& a = body.position[cell.nodes[i]];
      const auto& b = body.position[cell.nodes[(i + 1) % 4]];
      const auto& c = body.position[cell.nodes[(i + 2) % 4]];
      EXPECT_GT((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]), 0.0);
    }
}

TEST(DiscretisationTest, ShapesInterpolatePositionsAndGradientsTheirDerivative) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const auto& cell : body.cells)
    for (int q = 0; q < points_per_cell; ++q) {
      double radius = 0.0;
      double gradient[2][2] = {};
      for (int i = 0; i < nodes_per_cell; ++i) {
        const auto& x = body.position[cell.nodes[i]];
        radius += cell.shape[q][i] * x[0];
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b) gradient[a][b] += x[a] * cell.gradient[q][i][b];
      }
      EXPECT_NEAR(cell.radius[q], radius, 1e-14);
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) EXPECT_NEAR(gradient[a][b], a == b ? 1.0 : 0.0, 1e-13);
    }
}

TEST(DiscretisationTest, GroupsBecomeNodes) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  EXPECT_EQ(body.axis_nodes.size(), 6u);
  for (const int node : body.axis_nodes) EXPECT_EQ(body.position[node][0], 0.0);
  EXPECT_EQ(body.contact_nodes.size(), 5u);
  for (std::size_t i = 0; i < body.contact_nodes.size(); ++i) {
    EXPECT_EQ(body.position[body.contact_nodes[i]][1], 0.0);
    EXPECT_DOUBLE_EQ(body.position[body.contact_nodes[i]][0], 0.25 * static_cast<double>(i));
  }
}

TEST(DiscretisationTest, RefusesWhatWouldGiveAWrongAnswer) {
  const auto refuses = [](auto change) {
    Mesh mesh = test::distorted_cylinder();
    change(mesh);
    const Error error = testing::refusal_of([&] { discretise(mesh, 1.0); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return std::string(error.what());
  };
  EXPECT_NE(refuses([](Mesh& m) { m.cells.clear(); }).find("no cells"), std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.contact_edges.clear(); }).find("contact"), std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.vertices[0][0] = -1e-3; }).find("negative radius"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { std::swap(m.cells[3][1], m.cells[3][3]); }).find("mesh refused"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) {
              m.vertices[7] = {0.9, 1.1};
            }).find("mesh refused"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.vertices[7][0] = nan; }).find("mesh refused"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.axis_edges.pop_back(); }).find("axis"), std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) {
              m.axis_edges.push_back({1, 2});
            }).find("axis"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.cells[0][2] = 999; }).find("does not exist"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) {
              m.contact_edges.push_back({0, -1});
            }).find("no cell"),
            std::string::npos);
  EXPECT_NE(refuses([](Mesh& m) { m.vertices[2][1] = -0.01; }).find("below the plate"),
            std::string::npos);
}

}  // namespace
}  // namespace rebound::fem
