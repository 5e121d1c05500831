#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// χ² over data and priors, Σ r².
double left_of(const JointModel& model, const std::vector<double>& values);

/// What other starts of records must gain for a further search [of χ²].
inline constexpr double least_gain_of_a_search = 6.0;

/// The problem's unknowns start at these values, or at the bound that is next to them: a search may
/// end a rounding error beyond one.
void start_at(const std::vector<double>& values, CalibrationProblem& problem);

/// How a joint model is searched: lumped impacts are good to 1e-7; in FE no more of the cost can be
/// gained than what nodes that touch one by one make of it.
CalibrationControls search_controls(const JointModel& model);

/// Searches from the numbers that a problem of the model starts with, and from where forces jump,
/// where the model's do, and goes on from the better of both as search_with_settled_starts(). The
/// starts of `problem` are those of the last search after it.
/// Limit:  a dashpot that is looked for from the law's fit is found -> test
/// SettledStartsTest.AreTakenAlongBySearches
/// Errors: as calibrate().
CalibrationResult search_joint_model(const JointModel& model, CalibrationProblem& problem,
                                     const RunControl& control);

/// Searches once more from where a search has ended, as often as records fit plainly better from
/// other starts, five times at most. A rise within a sample or two is as good as a jump where the
/// colour of the noise is taken out.
/// Errors: as calibrate().
CalibrationResult search_with_settled_starts(const JointModel& model, CalibrationProblem& problem,
                                             CalibrationResult best, const RunControl& control);

}  // namespace rebound
