#pragma once

#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/search.hpp"

namespace rebound {

// Ceres as every search of a calibration uses it.

/// Stops Ceres when the user asks or the fit is exact, and tells how far it is.
class ProgressCallback final : public ceres::IterationCallback {
 public:
  ProgressCallback(const RunControl& control, const CalibrationControls& controls);
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override;

 private:
  const RunControl& control_;
  int iterations_;
  double exact_;  ///< cost over the first one
  double first_cost_ = 0.0;
  int taken_ = 0;  ///< iterations, of all parts of a search
};

ceres::Problem::Options search_ownership();
ceres::Solver::Options search_options(const CalibrationControls& controls);

/// Holds the i-th of the unknowns at y, scaled, within its bounds.
void bound(ceres::Problem& search, double* y, std::size_t i, const CalibrationParameter& unknown);

Attempt attempt_of(const ceres::Solver::Summary& summary, std::vector<double> y);

}  // namespace rebound
