#include "comparisons/accuracy/numerical_error/grid_convergence.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

GridError grid_convergence(const GridTriple& values) {
  constexpr double safety = 1.25, lowest_order = 0.5, highest_order = 2.0, largest_observed = 3.0;
  const double first = values.medium - values.coarse;
  const double second = values.fine - values.medium;
  GridError error;
  error.uncertainty = std::max(std::abs(second), 0.25 * std::abs(first));
  if (first * second <= 0.0 || std::abs(second) >= std::abs(first)) return error;
  const double order = std::log2(first / second);
  error.observed_order = order;
  if (order < lowest_order - 1e-9 || order > largest_observed) return error;
  error.basis = ErrorBasis::grid_convergence;
  error.uncertainty = safety * std::abs(second) / (std::exp2(std::min(order, highest_order)) - 1.0);
  return error;
}

double scatter_about_parabola(const std::array<double, 5>& y) {
  // The two combinations of five equally spaced values that no parabola moves.
  const double cubic = (-y[0] + 2.0 * y[1] - 2.0 * y[3] + y[4]) / std::sqrt(10.0);
  const double quartic = (y[0] - 4.0 * y[1] + 6.0 * y[2] - 4.0 * y[3] + y[4]) / std::sqrt(70.0);
  return std::sqrt(0.5 * (cubic * cubic + quartic * quartic));
}

}  // namespace rebound
