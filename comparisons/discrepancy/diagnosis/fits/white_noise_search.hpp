#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Are there effects, all of which act at first touch? A ring of high frequency is told by the
/// colour of the noise, and must be searched with it from the beginning.
bool acts_at_first_touch_alone(const Hypothesis& hypothesis);

/// The same shots with less and less white noise beside theirs: nothing else, a tenth of the
/// variance, a hundredth. What is not more than the past of the noise leaves open is left out.
/// Empty where noise is white, and in FE.
std::vector<Observations> with_white_noise_beside(const Observations& seen,
                                                  const Hypothesis& hypothesis);

/// The better of two searches: from where the unknowns start, and from where records fit best then.
/// Under smooth noise a force that is steep ends the first in a valley, and the search by stages,
/// too: of the damper that had made the data 3848 were left in χ² by both, and 3353 by its own
/// numbers with records that start where they fit best.
/// Limit:  a damper is found from its own numbers
///         -> test SettledStartsTest.AreTakenAlongAtTheUnseenSpeed
/// Errors: as calibrate().
CalibrationResult search_from_both(const JointModel& model, CalibrationProblem problem,
                                   const RunControl& control);

/// A search that begins where the same model fits best under the noise of the first stage, and goes
/// on stage by stage to its own. Once the colour of smooth noise is taken out, a rise within a few
/// samples is nearly all that a record says, and a search by slopes never leaves a record that
/// starts a sample too early.
///
///   stages  as with_white_noise_beside(), or the first of them
///
/// Nothing without a stage, where the search ends at no impact, and where no numbers come near the
/// data.
/// Limit:  what acts while the force falls is found from any start, too
///         -> test HypothesisFitTest.SlowRelaxationIsFoundFromAnyStart; a damper that rises within
///         a few samples is found from nothing
///         -> test SettledStartsTest.AreTakenAlongWhereTheForceIsSteep, also under the noise of a
///         filter -> test SettledStartsTest.AreTakenAlongByLessAndLessWhiteNoise
/// Errors: as calibrate(), but for impacts without an answer.
std::optional<CalibrationResult> search_by_stages(const std::vector<Observations>& stages,
                                                  const JointModel& model,
                                                  CalibrationProblem problem,
                                                  const RunControl& control);

}  // namespace rebound
