#pragma once

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// Appends (x − mean)/deviation of every prior.
void append_priors(const std::vector<CalibrationParameter>& parameters,
                   const std::vector<double>& x, std::vector<double>& residuals);

/// The problem with its priors as further residuals behind the data.
/// Errors: Error(bad_input) for a prior without width, or with unknown noise.
CalibrationProblem with_priors(const CalibrationProblem& problem);

/// The problem with the robust loss applied to its first `data` residuals:
/// r becomes sign(r) √ρ(r²), whose square is the loss.
///
///   scale   a, in units of the residuals
///
/// Limit: no loss leaves residuals as they are
///        -> test EffectiveResidualsTest.SmallResidualsAreLeftAlone.
CalibrationProblem with_loss(const CalibrationProblem& problem, std::size_t data, double scale);

/// 1.4826 times the median of |r|: the standard deviation of normal noise,
/// whatever a minority of wrong data does.
double robust_deviation(std::vector<double> residuals);

}  // namespace rebound
