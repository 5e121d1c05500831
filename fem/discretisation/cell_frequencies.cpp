#include <Eigen/Eigenvalues>

#include <algorithm>

#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Small-strain stiffness ∫ BᵀDB dV of one cell, displacements (r, z) by node.
Matrix8 stiffness_of(const CellGeometry& cell, const Moduli& moduli, const double* factors) {
  const double lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  Eigen::Matrix4d elasticity = Eigen::Matrix4d::Zero();  // rr, zz, tt, 2 rz
  elasticity.topLeftCorner<3, 3>().setConstant(lame);
  elasticity.diagonal() << lame + 2 * moduli.shear, lame + 2 * moduli.shear,
      lame + 2 * moduli.shear, moduli.shear;
  Matrix8 stiffness = Matrix8::Zero();
  for (int q = 0; q < points_per_cell; ++q) {
    Eigen::Matrix<double, 4, 8> b = Eigen::Matrix<double, 4, 8>::Zero();
    for (int i = 0; i < nodes_per_cell; ++i) {
      const auto& gradient = cell.gradient[q][i];
      b(0, 2 * i) = gradient[0];
      b(1, 2 * i + 1) = gradient[1];
      b(2, 2 * i) = cell.shape[q][i] / cell.radius[q];
      b(3, 2 * i) = gradient[1];
      b(3, 2 * i + 1) = gradient[0];
    }
    stiffness += (factors ? factors[q] : 1.0) * cell.weight[q] * b.transpose() * elasticity * b;
  }
  return stiffness;
}

}  // namespace

std::vector<double> cell_frequencies(const Discretisation& body, const Moduli& moduli,
                                     const PointFactors& factors) {
  std::vector<char> on_axis(body.position.size(), 0);
  for (const int node : body.axis_nodes) on_axis[node] = 1;
  std::vector<double> frequencies;
  frequencies.reserve(body.cells.size());
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellGeometry& cell = body.cells[c];
    Matrix8 matrix = stiffness_of(cell, moduli, factors.empty() ? nullptr : factors[c].data());
    Eigen::Matrix<double, 8, 1> scale;
    for (int i = 0; i < nodes_per_cell; ++i) {
      double mass = 0.0;
      for (int q = 0; q < points_per_cell; ++q)
        mass += body.density * cell.weight[q] * cell.shape[q][i];
      // A node on the axis cannot move radially: its row drops out.
      scale(2 * i) = on_axis[cell.nodes[i]] ? 0.0 : 1.0 / std::sqrt(mass);
      scale(2 * i + 1) = 1.0 / std::sqrt(mass);
    }
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix8> solver(matrix, Eigen::EigenvaluesOnly);
    frequencies.push_back(solver.eigenvalues().maxCoeff());
  }
  return frequencies;
}

}  // namespace rebound::fem
