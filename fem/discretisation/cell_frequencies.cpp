#include <Eigen/Eigenvalues>

#include <algorithm>

#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;

using StrainRows = Eigen::Matrix<double, 4, 8>;  ///< rr, zz, tt, 2 rz

/// Small-strain rows B of each point, displacements (r, z) by node.
std::array<StrainRows, points_per_cell> strain_rows_of(const CellGeometry& cell) {
  std::array<StrainRows, points_per_cell> rows;
  for (int q = 0; q < points_per_cell; ++q) {
    StrainRows& b = rows[q];
    b.setZero();
    for (int i = 0; i < nodes_per_cell; ++i) {
      const auto& gradient = cell.gradient[q][i];
      b(0, 2 * i) = gradient[0];
      b(1, 2 * i + 1) = gradient[1];
      b(2, 2 * i) = cell.shape[q][i] / cell.radius[q];
      b(3, 2 * i) = gradient[1];
      b(3, 2 * i + 1) = gradient[0];
    }
  }
  return rows;
}

/// B̄ = B + ⅓ 1 (mean of tr B − tr B): the derivative of mean_dilatation.inl at rest.
void share_dilatation(const CellGeometry& cell, std::array<StrainRows, points_per_cell>& rows) {
  using Row = Eigen::Matrix<double, 1, 8>;
  Row mean = Row::Zero();
  double volume = 0.0;
  for (int q = 0; q < points_per_cell; ++q) {
    mean += cell.weight[q] * rows[q].topRows<3>().colwise().sum();
    volume += cell.weight[q];
  }
  mean /= volume;
  for (StrainRows& b : rows) {
    const Row more = (mean - b.topRows<3>().colwise().sum()) / 3.0;
    b.topRows<3>().rowwise() += more;
  }
}

/// Small-strain stiffness ∫ BᵀDB dV of one cell.
Matrix8 stiffness_of(const CellGeometry& cell, const Moduli& moduli, const double* factors,
                     bool mean_dilatation) {
  const double lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  Eigen::Matrix4d elasticity = Eigen::Matrix4d::Zero();  // rr, zz, tt, 2 rz
  elasticity.topLeftCorner<3, 3>().setConstant(lame);
  elasticity.diagonal() << lame + 2 * moduli.shear, lame + 2 * moduli.shear,
      lame + 2 * moduli.shear, moduli.shear;
  Matrix8 stiffness = Matrix8::Zero();
  auto rows = strain_rows_of(cell);
  if (mean_dilatation) share_dilatation(cell, rows);
  for (int q = 0; q < points_per_cell; ++q)
    stiffness +=
        (factors ? factors[q] : 1.0) * cell.weight[q] * rows[q].transpose() * elasticity * rows[q];
  return stiffness;
}

}  // namespace

std::vector<double> cell_frequencies(const Discretisation& body, const Moduli& moduli,
                                     const CellStiffness& cells) {
  std::vector<char> on_axis(body.position.size(), 0);
  for (const int node : body.axis_nodes) on_axis[node] = 1;
  std::vector<double> frequencies;
  frequencies.reserve(body.cells.size());
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellGeometry& cell = body.cells[c];
    Matrix8 matrix =
        stiffness_of(cell, moduli, cells.factors.empty() ? nullptr : cells.factors[c].data(),
                     cells.mean_dilatation);
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
