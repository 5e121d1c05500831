#pragma once

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// Central differences of residuals at any point, inside the bounds:
///
///   ∂r/∂x_j ≈ [r(x_j + h_j) − r(x_j − h_j)]/(2 h_j),   h_j = step × scale_j
///
/// One-sided where a bound is nearer than a step, or where an impact of one side does not end.
/// Limit:  a side that has no residuals -> test ResidualSlopesTest.ASideWithoutAnImpactIsLeftOut.
/// Errors: those of the residual function at x, or on both sides of it.
ResidualsWithJacobian with_differences(const std::vector<CalibrationParameter>& parameters,
                                       const ResidualFunction& residuals,
                                       const std::vector<double>& x, double step);

}  // namespace rebound
