#pragma once

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// Largest 2 ΔC a value may cost to stay in the interval: the χ² quantile of
/// one degree of freedom, or s² times the F(1, N − M) quantile where the noise
/// is estimated.
double allowed_cost_increase(const CalibrationProblem& problem, const CalibrationResult& result,
                             std::size_t residuals);

/// Likelihood-ratio interval of one parameter: from the optimum outwards, all
/// others refitted, until 2 ΔC reaches what is allowed or a bound is met.
///
/// The crossing is found by secants on √(2 ΔC), which is a straight line where
/// the model is linear.
/// Errors: Error(interrupted) when asked to stop.
ProfileInterval profile_of(const CalibrationProblem& problem, const CalibrationResult& result,
                           std::size_t parameter, const RunControl& control);

/// The same with both sides walked at once: `below` and `above` are one problem twice, and share
/// nothing that two threads must not use together.
ProfileInterval profile_of(const CalibrationProblem& below, const CalibrationProblem& above,
                           const CalibrationResult& result, std::size_t parameter,
                           const RunControl& control);

}  // namespace rebound
