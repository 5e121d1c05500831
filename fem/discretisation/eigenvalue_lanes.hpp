#pragma once

#include <cmath>

#include "fem/discretisation/discretisation.hpp"

/// Largest eigenvalues of small symmetric matrices, one a lane.
///
///   A = Q T Qᵀ (Householder), p(λ) = |λ 1 − T| = 0 by Newton's method from above
///
/// All of it is inlined into what asks: wide vectors have no calling convention of their own
/// outside functions for their instruction set.
///
/// Limit:  Eigen's largest eigenvalue -> test CellFrequencies.AreThoseOfEigen
/// Source: Golub & Van Loan, Matrix Computations, section 8.3.1 (reduction).
namespace rebound::fem::eigenvalue_lanes {

/// As many cells go side by side, one a lane: a cell alone is too small for vectors.
constexpr int lanes = 8;
typedef double Lanes __attribute__((vector_size(8 * lanes)));

constexpr int size = 2 * nodes_per_cell;  ///< displacements of a cell, (r, z) by node
using Matrices = Lanes[size][size];       ///< of each lane; the lower triangle counts

/// A symmetric tridiagonal matrix: its diagonal, and the squares beside it.
struct Tridiagonal {
  Lanes diagonal[size], beside[size - 1], beside_squared[size - 1];
};

[[gnu::always_inline]] inline void root(const Lanes& squared, Lanes& out) {
  for (int lane = 0; lane < lanes; ++lane) out[lane] = std::sqrt(squared[lane]);
}

/// Householder's reduction; `a` is used up.
[[gnu::always_inline]] inline void reduce(Matrices& a, Tridiagonal& t) {
  const Lanes zero = {};
  for (int k = 0; k < size - 1; ++k) {
    t.diagonal[k] = a[k][k];
    Lanes squared = zero, norm;
    for (int i = k + 1; i < size; ++i) squared += a[i][k] * a[i][k];
    root(squared, norm);
    t.beside_squared[k] = squared;
    t.beside[k] = norm;
    if (k == size - 2) break;
    // H = 1 − β v vᵀ, β = 2/vᵀv.
    Lanes v[size], p[size];
    const Lanes first = a[k + 1][k], length = first < 0.0 ? -first : first;
    for (int i = k + 1; i < size; ++i) {
      v[i] = a[i][k];
      p[i] = zero;
    }
    v[k + 1] += first < 0.0 ? -norm : norm;
    const Lanes beta = squared > 0.0 ? 1.0 / (squared + length * norm) : zero;
    for (int i = k + 1; i < size; ++i) {
      for (int j = k + 1; j < i; ++j) {
        p[i] += a[i][j] * v[j];
        p[j] += a[i][j] * v[i];
      }
      p[i] += a[i][i] * v[i];
    }
    Lanes along = zero;
    for (int i = k + 1; i < size; ++i) {
      p[i] *= beta;
      along += p[i] * v[i];
    }
    along *= 0.5 * beta;
    for (int i = k + 1; i < size; ++i) p[i] -= along * v[i];
    for (int i = k + 1; i < size; ++i)
      for (int j = k + 1; j <= i; ++j) a[i][j] -= v[i] * p[j] + p[i] * v[j];
  }
  t.diagonal[size - 1] = a[size - 1][size - 1];
}

/// Largest root of the characteristic polynomial by Newton's method from Gershgorin's bound,
/// whence it falls to that root without a step too far.
[[gnu::always_inline]] inline void largest_eigenvalue(const Tridiagonal& t, Lanes& largest) {
  largest = t.diagonal[0] + t.beside[0];
  for (int i = 1; i < size; ++i) {
    Lanes reach = t.diagonal[i] + t.beside[i - 1];
    if (i < size - 1) reach += t.beside[i];
    largest = reach > largest ? reach : largest;
  }
  constexpr double resolution = 4e-16;
  for (bool falls = true; falls;) {
    Lanes p_before = Lanes{} + 1.0, p = largest - t.diagonal[0];
    Lanes slope_before = {}, slope = p_before;
    for (int i = 1; i < size; ++i) {
      const Lanes by = largest - t.diagonal[i], squared = t.beside_squared[i - 1];
      const Lanes p_next = by * p - squared * p_before;
      const Lanes slope_next = p + by * slope - squared * slope_before;
      p_before = p;
      p = p_next;
      slope_before = slope;
      slope = slope_next;
    }
    const Lanes next = largest - p / slope;
    const auto lower = next < (1.0 - resolution) * largest;  // false of what is no number
    largest = lower ? next : largest;
    falls = false;
    for (int lane = 0; lane < lanes; ++lane) falls = falls || lower[lane];
  }
}

}  // namespace rebound::fem::eigenvalue_lanes
