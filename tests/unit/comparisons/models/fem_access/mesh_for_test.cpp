#include "comparisons/models/fem_access/mesh_for.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"

namespace rebound {
namespace {

FemProblem ball(double speed, int cells) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = speed;
  problem.material = {.youngs_modulus = 10e6, .poisson_ratio = 0.4};
  problem.cells = cells;
  return problem;
}

double expected_radius(const FemProblem& problem) {
  return fem::expected_contact_radius(problem, fem::instantaneous_moduli(problem.material));
}

int nodes_within(const Mesh& mesh, double radius) {
  std::set<int> inside;
  for (const auto& edge : mesh.contact_edges)
    for (const int vertex : edge)
      if (mesh.vertices[vertex][0] <= radius) inside.insert(vertex);
  return static_cast<int>(inside.size());
}

TEST(MeshForTest, ResolvesTheContact) {
  for (const int cells : {250, 1000, 4000})
    for (const double speed : {0.1, 0.5, 2.0, 15.0}) {
      const FemProblem problem = ball(speed, cells);
      EXPECT_GE(nodes_within(mesh_for(problem), expected_radius(problem)), 8)
          << cells << " " << speed;
    }
}

TEST(MeshForTest, AStiffBallHasASmallerContact) {
  const auto smallest_edge = [](const FemProblem& problem) {
    const Mesh mesh = mesh_for(problem);
    double smallest = 1.0;
    for (const auto& [a, b] : mesh.contact_edges)
      smallest = std::min(smallest, std::hypot(mesh.vertices[a][0] - mesh.vertices[b][0],
                                               mesh.vertices[a][1] - mesh.vertices[b][1]));
    return smallest;
  };
  FemProblem stiff = ball(2.0, 500), long_term = ball(2.0, 500), layered = ball(2.0, 500);
  stiff.material.youngs_modulus = 1e9;
  long_term.material.modulus = ModulusBasis::long_term;
  long_term.material.branches = {{.ratio = 20.0, .relaxation_time = 1e-3}};
  layered.material.layers = {{.from = 0.8, .modulus_factor = 30.0}};
  for (const FemProblem& harder : {stiff, long_term, layered})
    EXPECT_LT(smallest_edge(harder), 0.8 * smallest_edge(ball(2.0, 500)));
}

TEST(MeshForTest, ExpectsTheRadiusThatFeFinds) {
  if (!has_fem_tier()) return;
  const auto found_over_expected = [](double speed) {
    const FemProblem problem = ball(speed, 1000);
    return fem_tier().simulate(problem, mesh_for(problem), {}).contact_radius_peak /
           expected_radius(problem);
  };
  EXPECT_NEAR(found_over_expected(0.5), 1.0, 0.1);  // of 8 nodes the last is one tenth of it
  EXPECT_NEAR(found_over_expected(15.0), 1.0, 0.05);
}

}  // namespace
}  // namespace rebound
