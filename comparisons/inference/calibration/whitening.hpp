#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"

/// From differences in newtons to residuals of unit variance: W r with WᵀW the inverse of the
/// covariance of a history, the same W for residuals and their slopes. Another covariance is
/// another W here and nowhere else.
namespace rebound {

/// The history's residuals (model − data) divided by its errors: noise of whatever colour and,
/// within blocks, the shared error.
///
/// Limit: u = 0 divides by σ alone -> test WhiteningTest.SharedErrorBoundsABlock.
std::vector<double> whitened(const MeasuredImpact& measured, const std::vector<double>& model);

/// The same of the deflections, over the samples in `range`; `model` is over them alone.
std::vector<double> whitened_deflections(const MeasuredImpact& measured, const SampleRange& range,
                                         const std::vector<double>& model);

/// The part of W that is not division by σ, in place on rows that are divided already:
/// residuals (`width` 1) or their slopes (`width` the number of unknowns).
///
/// Of coloured noise, what its neighbours before it predict is taken out of a row, and what is
/// left divided by its standard deviation: r_i ← (r_i − Σ a_k r_(i−k))/√v, with the best predictor
/// from as many neighbours as there are.
/// The mean of a block is then divided by √(σ² + N u²)/σ: however many its samples, a block is not
/// known better than u.
/// Limit: W C Wᵀ = 1 -> tests WhiteningTest.UndoesTheCovarianceOfABlock,
///        UndoesTheCovarianceOfCorrelatedNoise.
/// Caution: with both, the shared error is that of the rows after the first step.
void take_out_correlation(const ForceNoise& noise, std::span<double> rows, std::size_t width = 1);

/// The last rows of a list that grows.
inline std::span<double> last_of(std::vector<double>& all, std::size_t count) {
  return std::span<double>(all).last(count);
}

}  // namespace rebound
