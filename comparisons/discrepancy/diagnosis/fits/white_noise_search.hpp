#pragma once

#include <optional>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A search that begins where the same model fits best with noise that is taken as white. Once the
/// colour of smooth noise is taken out, a rise within a few samples is nearly all that a record
/// says, and a search by slopes never leaves a record that starts a sample too early.
///
///   seen    what the model was made of
///
/// Nothing where noise is white, where no effect acts at first touch (families rate and surface),
/// in FE, and where the search ends at no impact.
/// Limit:  a damper that rises within a few samples is found from nothing
///         -> test SettledStartsTest.AreTakenAlongWhereTheForceIsSteep
/// Errors: as calibrate(), but for impacts without an answer.
std::optional<CalibrationResult> search_by_white_noise(const Observations& seen,
                                                       const JointModel& model,
                                                       CalibrationProblem problem,
                                                       const RunControl& control);

}  // namespace rebound
