#pragma once

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// How a joint model is searched: lumped impacts are good to 1e-7; in FE no more of the cost can be
/// gained than what nodes that touch one by one make of it.
CalibrationControls search_controls(const JointModel& model);

/// Searches from the numbers that a problem of the model starts with, and from where forces jump,
/// where the model's do; there from the better of both once more, twice at most, where records fit
/// better from other starts. The starts of `problem` are those of the last search after it.
/// Limit:  a dashpot that is looked for from the law's fit is found -> test
/// SettledStartsTest.AreTakenAlongBySearches
/// Errors: as calibrate().
CalibrationResult search_joint_model(const JointModel& model, CalibrationProblem& problem,
                                     const RunControl& control);

}  // namespace rebound
