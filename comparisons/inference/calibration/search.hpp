#pragma once

#include <vector>

#include "comparisons/inference/calibration/calibration_cost.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// ½ Σ r²: the cost of residuals.
double half_square(const std::vector<double>& residuals);

/// Where one search ended, in scaled unknowns.
struct Attempt {
  std::vector<double> y;
  double cost = 0.0;  ///< ½ Σ r²
  bool converged = false;
  bool interrupted = false;
};

/// One Levenberg–Marquardt search from y, within the bounds. An error of the
/// residual function other than "no answer here" is thrown on.
Attempt search_from(std::vector<double> y, const CalibrationProblem& problem, CalibrationCost& cost,
                    const RunControl& control);

}  // namespace rebound
