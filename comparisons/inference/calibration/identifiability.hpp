#pragma once

#include <Eigen/Core>

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// An optimum in scaled unknowns y = x / scale, with what surrounds it.
struct Optimum {
  Eigen::VectorXd y;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;   ///< ∂r/∂y, or fewer rows of the same JᵀJ
  std::vector<bool> at_edge;  ///< the model has no answer on one side of this parameter
};

/// Fills estimates, correlation, verdicts and warnings of `result`.
///
/// Unidentifiable is said of a parameter that
///   – takes part in a direction of y along which no residual changes
///     (singular value below 1e-5 of the largest: what steps of 1e-4 resolve in a
///     model smooth to 1e-9), or
///   – has a standard error wider than its bounds are apart, or
///   – sits where the model stops having an answer, not where it fits best.
/// Weakly identified is said of a parameter whose standard error is more than a
/// quarter of its scale, or whose prior holds it rather than the data.
/// Limit: two parameters that enter as a product are both named, together
///        -> test CalibrateTest.NamesAProductOfTwo.
void assess(const CalibrationProblem& problem, const Optimum& optimum, CalibrationResult& result);

/// Judges a parameter anew by its likelihood-ratio interval: open to both
/// bounds is not identifiable, open to one weakly identified.
void judge_profile(const CalibrationProblem& problem, std::size_t parameter,
                   CalibrationResult& result);

/// The one sentence on the whole fit, from the verdicts of its parameters.
void conclude(const CalibrationProblem& problem, CalibrationResult& result);

}  // namespace rebound
