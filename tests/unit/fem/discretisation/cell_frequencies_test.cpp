// Eigenfrequencies of single cells, four at a time by Householder and Newton, against Eigen's
// solver on matrices that are put together here.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/cell_frequencies.hpp"

namespace rebound::fem {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using StrainRows = Eigen::Matrix<double, 4, 8>;  // rr, zz, tt, 2 rz

StrainRows strain_rows(const CellGeometry& cell, int q) {
  StrainRows b = StrainRows::Zero();
  for (int i = 0; i < nodes_per_cell; ++i) {
    b(0, 2 * i) = b(3, 2 * i + 1) = cell.gradient[q][i][0];
    b(1, 2 * i + 1) = b(3, 2 * i) = cell.gradient[q][i][1];
    b(2, 2 * i) = cell.shape[q][i] / cell.radius[q];
  }
  return b;
}

double by_eigen(const Discretisation& body, const Moduli& moduli, const CellStiffness& asked,
                std::size_t number) {
  const CellGeometry& cell = body.cells[number];
  Eigen::Matrix<double, 1, 8> mean = Eigen::Matrix<double, 1, 8>::Zero();
  double volume = 0.0;
  for (int q = 0; q < points_per_cell; ++q) {
    mean += cell.weight[q] * strain_rows(cell, q).topRows<3>().colwise().sum();
    volume += cell.weight[q];
  }
  Eigen::Matrix4d elasticity = Eigen::Matrix4d::Zero();
  elasticity.topLeftCorner<3, 3>().setConstant(moduli.bulk - 2.0 / 3.0 * moduli.shear);
  elasticity.diagonal().head<3>().array() += 2.0 * moduli.shear;
  elasticity(3, 3) = moduli.shear;
  Matrix8 stiffness = Matrix8::Zero();
  Eigen::Matrix<double, 8, 1> mass = Eigen::Matrix<double, 8, 1>::Zero();
  for (int q = 0; q < points_per_cell; ++q) {
    StrainRows b = strain_rows(cell, q);
    if (asked.mean_dilatation) {
      const auto more = ((mean / volume - b.topRows<3>().colwise().sum()) / 3.0).eval();
      b.topRows<3>().rowwise() += more;
    }
    const double factor = asked.factors.empty() ? 1.0 : asked.factors[number][q];
    stiffness += factor * cell.weight[q] * (b.transpose() * elasticity * b);
    for (int j = 0; j < 8; ++j) mass(j) += body.density * cell.weight[q] * cell.shape[q][j / 2];
  }
  Eigen::Matrix<double, 8, 1> scale = mass.cwiseSqrt().cwiseInverse();
  for (const int node : body.axis_nodes)
    for (int i = 0; i < nodes_per_cell; ++i)
      if (cell.nodes[i] == node) scale(2 * i) = 0.0;
  const Matrix8 scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix8>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// Distorted cells, and the nearly square ones of a sphere far from its axis: without a Poisson
// ratio three of their frequencies lie together at the top.
TEST(CellFrequencies, AreThoseOfEigen) {
  test::Random random(23);
  std::vector<Discretisation> bodies = {
      discretise(generate_sphere_mesh({.radius = 0.0331, .cells = 250}), 0.0896)};
  for (int i = 0; i < 30; ++i)
    bodies.push_back(discretise(test::random_cell(random, i % 3 == 0), 1.0));
  for (const Discretisation& body : bodies)
    for (const double poisson_ratio : {0.0, 0.3, 0.499})
      for (const bool mean_dilatation : {false, true})
        for (const bool layered : {false, true}) {
          CellStiffness asked{.mean_dilatation = mean_dilatation};
          for (std::size_t c = 0; layered && c < body.cells.size(); ++c)
            asked.factors.push_back({1.0, 1.0, random.between(0.2, 5.0), 3.0});
          const Moduli moduli{.shear = 0.5e7 / (1.0 + poisson_ratio),
                              .bulk = 1e7 / (3.0 - 6.0 * poisson_ratio)};
          const auto found = cell_frequencies(body, moduli, asked);
          for (std::size_t c = 0; c < body.cells.size(); ++c) {
            const double expected = by_eigen(body, moduli, asked, c);
            EXPECT_NEAR(found[c], expected, 2e-14 * expected) << c << " at " << poisson_ratio;
          }
        }
}

}  // namespace
}  // namespace rebound::fem
