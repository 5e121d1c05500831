#pragma once

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// Central differences of residuals at any point, inside the bounds:
///
///   ∂r/∂x_j ≈ [r(x_j + h_j) − r(x_j − h_j)]/(2 h_j),   h_j = step × scale_j
///
/// One-sided where a bound is nearer than a step.
/// Errors: those of the residual function.
ResidualsWithJacobian with_differences(const std::vector<CalibrationParameter>& parameters,
                                       const ResidualFunction& residuals,
                                       const std::vector<double>& x, double step);

}  // namespace rebound
