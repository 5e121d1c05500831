#include "comparisons/discrepancy/diagnosis/believed_fem/contact_ripple.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

namespace rebound {
namespace {

constexpr Eigen::Index narrower = 3;  // times, at its ends, where the force starts as t^1.5

/// Weights of points −before … after for the value at 0 of the parabola through them.
Eigen::VectorXd weights_of(Eigen::Index before, Eigen::Index after) {
  Eigen::MatrixXd powers(before + after + 1, 3);
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const auto x = static_cast<double>(i - before);
    powers.row(i) << 1.0, x, x * x;
  }
  const Eigen::MatrixXd inverse = powers.completeOrthogonalDecomposition().pseudoInverse();
  return inverse.row(0).transpose();
}

}  // namespace

double ripple_width(int cells) {
  constexpr double width = 0.06, of_cells = 300.0;
  return width * std::sqrt(of_cells / std::max(cells, 1));
}

std::vector<double> without_ripple(const std::vector<double>& force, double half_width) {
  const auto count = static_cast<Eigen::Index>(force.size());
  const auto width = static_cast<Eigen::Index>(half_width * static_cast<double>(count - 1));
  const Eigen::Map<const Eigen::VectorXd> raw(force.data(), count);
  std::vector<double> smooth(force.size());
  std::map<std::pair<Eigen::Index, Eigen::Index>, Eigen::VectorXd> known;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index to_end = std::min(i, count - 1 - i);
    const Eigen::Index half = std::min(width, std::max(width / narrower, to_end));
    const Eigen::Index before = std::min(half, i), after = std::min(half, count - 1 - i);
    const auto [weights, added] = known.try_emplace({before, after});
    if (added) weights->second = weights_of(before, after);
    smooth[static_cast<std::size_t>(i)] =
        weights->second.dot(raw.segment(i - before, before + after + 1));
  }
  smooth.front() = force.front();
  smooth.back() = force.back();
  return smooth;
}

}  // namespace rebound
