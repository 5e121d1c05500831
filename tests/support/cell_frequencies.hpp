#pragma once

#include <Eigen/Eigenvalues>
#include <vector>

#include "tests/support/fem_cases.hpp"

namespace rebound::test {

/// A random quadrilateral, a third of them on the axis.
inline Mesh random_cell(Random& random, bool at_axis) {
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
inline std::vector<double> random_cell_motion(Random& random, const fem::Discretisation& body,
                                              double size) {
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

/// ω² of one cell from the derivative of its forces by differences [1/s²].
inline double largest_frequency_squared(const fem::Discretisation& body, KernelCase& cell,
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

}  // namespace rebound::test
