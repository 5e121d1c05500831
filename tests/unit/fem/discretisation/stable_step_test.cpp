// The stable step: eigenfrequencies of one cell, found from its forces by
// differences, against what the scheme takes for them.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

/// A random quadrilateral, a third of them on the axis.
Mesh random_cell(test::Random& random, bool at_axis) {
  const double r = at_axis ? 0.0 : random.between(0.2, 5.0);
  Mesh mesh;
  mesh.vertices = {{r, 0.3},
                   {r + 1.0, 0.3 + 0.2 * random()},
                   {r + 1.0 + 0.2 * random(), 1.3 + 0.2 * random()},
                   {at_axis ? 0.0 : r + 0.1 * random(), 1.3 + 0.2 * random()}};
  mesh.cells = {{0, 1, 2, 3}};
  mesh.contact_edges = {{0, 1}};
  if (at_axis) mesh.axis_edges = {{3, 0}};
  return mesh;
}

/// Homogeneous strain and shear up to `size`, and a third of it at random.
std::vector<double> random_motion(test::Random& random, const Discretisation& body, double size) {
  const double a = size * random(), b = size * random(), c = size * random(), d = size * random();
  std::vector<double> u(2 * (body.position.size() + 1), 0.0);
  for (int node = 0; node < body.node_count(); ++node) {
    const auto& [r, z] = body.position[node];
    u[2 * node] = a * r + (body.axis_nodes.empty() ? c * z : 0.0) + 0.3 * size * random();
    u[2 * node + 1] = b * z + d * r + 0.3 * size * random();
  }
  for (const int node : body.axis_nodes) u[2 * node] = 0.0;
  return u;
}

double largest_frequency_squared(const Discretisation& body, test::KernelCase& cell,
                                 const std::vector<double>& u) {
  Eigen::Matrix<double, 8, 8> stiffness;
  Eigen::Matrix<double, 8, 1> scale;
  constexpr double step = 1e-6;
  for (int j = 0; j < 8; ++j) {
    auto moved = u;
    moved[j] += step;
    const auto ahead = cell.force(moved);
    moved[j] -= 2 * step;
    const auto behind = cell.force(moved);
    for (int i = 0; i < 8; ++i) stiffness(i, j) = (ahead[i] - behind[i]) / (2 * step);
    scale(j) = 1.0 / std::sqrt(body.mass[j / 2]);
  }
  for (const int node : body.axis_nodes) scale(2 * node) = 0.0;
  stiffness =
      (scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal())
          .eval();
  return Eigen::SelfAdjointEigenSolver<decltype(stiffness)>(stiffness, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

class StableStep : public ::testing::TestWithParam<ElasticModel> {};

TEST_P(StableStep, FrequencyOfCellAtRest) {
  test::Random random(21);
  for (int i = 0; i < 60; ++i) {
    const auto body = discretise(random_cell(random, i % 3 == 0), 1.0);
    test::KernelCase cell(body, test::unit_material(GetParam()), *find_cell_kernel("baseline"));
    const std::vector<double> rest(cell.size(), 0.0);
    cell.force(rest);
    EXPECT_NEAR(
        largest_frequency_squared(body, cell, rest) / cell.summary().largest_frequency_squared, 1.0,
        5e-6);  // of the difference quotients
  }
}

TEST_P(StableStep, FrequencyOfDeformedCell) {
  // Strains up to 0.65: what a step safety of 1 would let pass is 1.
  for (const double poisson_ratio : {0.0, 0.3, 0.4, 0.45}) {
    test::Random random(22);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const auto body = discretise(random_cell(random, i % 3 == 0), 1.0);
      Material material = test::unit_material(GetParam());
      material.poisson_ratio = poisson_ratio;
      test::KernelCase cell(body, material, *find_cell_kernel("baseline"));
      const auto u = random_motion(random, body, i % 2 == 0 ? 0.2 : 0.5);
      cell.force(u);
      const CellSummary summary = cell.summary();
      if (summary.smallest_jacobian < 0.15) continue;
      worst = std::max(
          worst, largest_frequency_squared(body, cell, u) / summary.largest_frequency_squared);
    }
    EXPECT_LT(worst, 1.03) << "Poisson ratio " << poisson_ratio;
    EXPECT_GT(worst, 0.5) << "the estimate wastes steps";
  }
}

INSTANTIATE_TEST_SUITE_P(Elastic, StableStep, ::testing::ValuesIn(test::elastic_models));

}  // namespace
}  // namespace rebound::fem
