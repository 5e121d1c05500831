#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

/// From differences in newtons to residuals of unit variance: W r with WᵀW the inverse of the
/// covariance of a history, the same W for residuals and their slopes. Another covariance is
/// another W here and nowhere else.
namespace rebound {

/// The history's residuals (model − data) divided by its errors: white noise and, within
/// blocks, the shared error.
///
/// Limit: u = 0 divides by σ alone -> test WhiteningTest.SharedErrorBoundsABlock.
std::vector<double> whitened(const MeasuredImpact& measured, const std::vector<double>& model);

/// The part of W that is not division by σ, in place on rows that are divided already:
/// residuals (`width` 1) or their slopes (`width` the number of unknowns).
///
/// The mean of a block is divided by √(σ² + N u²)/σ as well: however many its samples, a block
/// is not known better than u.
void take_out_shared_error(const ForceNoise& noise, std::span<double> rows, std::size_t width = 1);

/// The last rows of a list that grows.
inline std::span<double> last_of(std::vector<double>& all, std::size_t count) {
  return std::span<double>(all).last(count);
}

}  // namespace rebound
