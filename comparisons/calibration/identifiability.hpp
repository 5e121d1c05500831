#pragma once

#include <Eigen/Core>

#include "comparisons/calibration/calibration_problem.hpp"

namespace rebound {

/// An optimum in scaled unknowns y = x / scale, with what surrounds it.
struct Optimum {
  Eigen::VectorXd y;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< ∂r/∂y
};

/// Fills estimates, correlation, verdicts and warnings of `result`.
///
/// Unidentifiable is said of a parameter that
///   – takes part in a direction of y along which no residual changes
///     (singular value below 1e-5 of the largest: what steps of 1e-4 resolve in a
///     model smooth to 1e-9), or
///   – has a standard error wider than its bounds are apart.
/// Limit: two parameters that enter as a product are both named, together
///        -> test CalibrateTest.NamesAProductOfTwo.
void assess(const CalibrationProblem& problem, const Optimum& optimum, CalibrationResult& result);

}  // namespace rebound
