#include <algorithm>
#include <cmath>

#include "fem/discretisation/discretisation.hpp"
#include "fem/discretisation/eigenvalue_lanes.hpp"

namespace rebound::fem {
namespace {

using namespace eigenvalue_lanes;

using Group = std::array<int, lanes>;  ///< numbers of cells

/// Small-strain rows B of one point: ε_rr, ε_zz, ε_tt, 2 ε_rz by displacements over √mass.
struct StrainRows {
  Lanes rr[nodes_per_cell], tt[nodes_per_cell], rz_of_r[nodes_per_cell];  ///< by u_r
  Lanes zz[nodes_per_cell], rz_of_z[nodes_per_cell];                      ///< by u_z
  Lanes dilatation[size];                                                 ///< ε_rr + ε_zz + ε_tt
  Lanes weight;                                                           ///< [m³]
  Lanes modulus_weight;  ///< with the factor of a layer
};

/// 1/√m of each displacement; 0 where a node of the axis cannot move.
[[gnu::always_inline]] inline void inverse_roots_of_mass(const Discretisation& body,
                                                         const Group& group,
                                                         const std::vector<char>& on_axis,
                                                         Lanes* scale) {
  for (int lane = 0; lane < lanes; ++lane) {
    const CellGeometry& cell = body.cells[group[lane]];
    for (int i = 0; i < nodes_per_cell; ++i) {
      double mass = 0.0;
      for (int q = 0; q < points_per_cell; ++q)
        mass += body.density * cell.weight[q] * cell.shape[q][i];
      const double root = 1.0 / std::sqrt(mass);
      scale[2 * i][lane] = on_axis[cell.nodes[i]] ? 0.0 : root;
      scale[2 * i + 1][lane] = root;
    }
  }
}

[[gnu::always_inline]] inline void fill_strain_rows(const Discretisation& body, const Group& group,
                                                    int q, const PointFactors& factors,
                                                    const Lanes* scale, StrainRows& rows) {
  for (int lane = 0; lane < lanes; ++lane) {
    const CellGeometry& cell = body.cells[group[lane]];
    for (int i = 0; i < nodes_per_cell; ++i) {
      const auto& gradient = cell.gradient[q][i];
      rows.rr[i][lane] = gradient[0];
      rows.zz[i][lane] = gradient[1];
      rows.tt[i][lane] = cell.shape[q][i] / cell.radius[q];
    }
    rows.weight[lane] = cell.weight[q];
    rows.modulus_weight[lane] = (factors.empty() ? 1.0 : factors[group[lane]][q]) * cell.weight[q];
  }
  for (int i = 0; i < nodes_per_cell; ++i) {
    rows.rz_of_r[i] = rows.zz[i] * scale[2 * i];
    rows.rz_of_z[i] = rows.rr[i] * scale[2 * i + 1];
    rows.rr[i] *= scale[2 * i];
    rows.tt[i] *= scale[2 * i];
    rows.zz[i] *= scale[2 * i + 1];
    rows.dilatation[2 * i] = rows.rr[i] + rows.tt[i];
    rows.dilatation[2 * i + 1] = rows.zz[i];
  }
}

/// A += c a aᵀ.
[[gnu::always_inline]] inline void add_square(const Lanes& c, const Lanes* a, Matrices& matrix) {
  for (int i = 0; i < size; ++i) {
    const Lanes factor = c * a[i];
    for (int j = 0; j <= i; ++j) matrix[i][j] += factor * a[j];
  }
}

/// 2 μ ε:ε of one point.
[[gnu::always_inline]] inline void add_shear(double shear, const StrainRows& rows,
                                             Matrices& matrix) {
  const Lanes one = shear * rows.modulus_weight, two = 2.0 * one;
  for (int i = 0; i < nodes_per_cell; ++i) {
    const Lanes rr = two * rows.rr[i], tt = two * rows.tt[i], zz = two * rows.zz[i];
    const Lanes of_r = one * rows.rz_of_r[i], of_z = one * rows.rz_of_z[i];
    for (int j = 0; j <= i; ++j) {
      matrix[2 * i][2 * j] += rr * rows.rr[j] + tt * rows.tt[j] + of_r * rows.rz_of_r[j];
      matrix[2 * i + 1][2 * j] += of_z * rows.rz_of_r[j];
      if (j < i) matrix[2 * i][2 * j + 1] += of_r * rows.rz_of_z[j];
      matrix[2 * i + 1][2 * j + 1] += zz * rows.zz[j] + of_z * rows.rz_of_z[j];
    }
  }
}

/// M^-½ K M^-½ of each cell, K = ∫ λ (tr ε)² + 2 μ ε:ε dV. With a mean dilatation, the derivative
/// of mean_dilatation.inl at rest: tr ε is the cell's mean in K/2 (tr ε)², its own in the deviator.
[[gnu::always_inline]] inline void fill_matrices(const Discretisation& body, const Group& group,
                                                 const Moduli& moduli, const CellStiffness& cells,
                                                 const Lanes* scale, Matrices& matrix) {
  const double third = -2.0 / 3.0 * moduli.shear;
  for (auto& row : matrix)
    for (Lanes& value : row) value = Lanes{};
  Lanes mean[size] = {}, volume = {}, modulus_volume = {};
  StrainRows rows;
  for (int q = 0; q < points_per_cell; ++q) {
    fill_strain_rows(body, group, q, cells.factors, scale, rows);
    add_shear(moduli.shear, rows, matrix);
    const double lame = cells.mean_dilatation ? third : moduli.bulk + third;
    add_square(lame * rows.modulus_weight, rows.dilatation, matrix);
    for (int i = 0; i < size; ++i) mean[i] += rows.weight * rows.dilatation[i];
    volume += rows.weight;
    modulus_volume += rows.modulus_weight;
  }
  if (cells.mean_dilatation)
    add_square(moduli.bulk * modulus_volume / (volume * volume), mean, matrix);
}

/// Cells and what is asked of them.
struct Question {
  const Discretisation& body;
  const Moduli& moduli;
  const CellStiffness& stiffness;
  std::vector<char> on_axis;  ///< by node
};

[[gnu::always_inline]] inline void fill_frequencies(const Question& asked,
                                                    std::vector<double>& frequencies) {
  const auto count = static_cast<int>(frequencies.size());
  for (int first = 0; first < count; first += lanes) {
    Group group;
    for (int lane = 0; lane < lanes; ++lane) group[lane] = std::min(first + lane, count - 1);
    Lanes scale[size], largest;
    Matrices matrix;
    Tridiagonal reduced;
    inverse_roots_of_mass(asked.body, group, asked.on_axis, scale);
    fill_matrices(asked.body, group, asked.moduli, asked.stiffness, scale, matrix);
    reduce(matrix, reduced);
    largest_eigenvalue(reduced, largest);
    for (int lane = 0; lane < lanes; ++lane) frequencies[group[lane]] = largest[lane];
  }
}

void fill_plainly(const Question& asked, std::vector<double>& frequencies) {
  fill_frequencies(asked, frequencies);
}

#if defined(__x86_64__)
// Without FMA, so that every bit is the same.
[[gnu::target("avx")]] void fill_with_avx(const Question& asked, std::vector<double>& frequencies) {
  fill_frequencies(asked, frequencies);
}
[[gnu::target("avx512f")]] void fill_with_avx512(const Question& asked,
                                                 std::vector<double>& frequencies) {
  fill_frequencies(asked, frequencies);
}
#endif

}  // namespace

std::vector<double> cell_frequencies(const Discretisation& body, const Moduli& moduli,
                                     const CellStiffness& cells) {
  Question asked{body, moduli, cells, std::vector<char>(body.position.size(), 0)};
  for (const int node : body.axis_nodes) asked.on_axis[node] = 1;
  std::vector<double> frequencies(body.cells.size());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) {
    fill_with_avx512(asked, frequencies);
    return frequencies;
  }
  if (__builtin_cpu_supports("avx")) {
    fill_with_avx(asked, frequencies);
    return frequencies;
  }
#endif
  fill_plainly(asked, frequencies);
  return frequencies;
}

}  // namespace rebound::fem
