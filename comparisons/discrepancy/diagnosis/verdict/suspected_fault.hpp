#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// The verdict is a fault of the measurement, with nothing withheld. Effects that were found before
/// are the caller's to drop.
///
///   candidates   faults by name, one of which it is; empty: the data say that there is one, and
///                not which
///   fault        in words, for the headline
void suspect_measurement(Diagnosis& diagnosis, std::vector<std::vector<std::string>> candidates,
                         std::string fault);

/// Where a model agrees with readings that are rounded to steps of more than twice all other noise,
/// the steps are said: within them it agrees. So they are where nothing explains a cell of the map
/// and χ² is that of noise: the errors of neighbours that are rounded alike are alike.
void suspect_a_coarse_recorder(Diagnosis& diagnosis, const SelectionRules& rules);

/// Where a model agrees with forces whose offset was taken out before anything was looked for, the
/// offset is said.
void suspect_an_offset(Diagnosis& diagnosis);

/// Where a model agrees with what it was fitted to, and all shots together show what one of them
/// would make that is off by itself, that is said: it is one of the unseen speed.
void suspect_a_shot_that_no_fit_saw(Diagnosis& diagnosis);

/// Where nothing explains the data, and impulse, energy or restitution contradict each other as no
/// fitted model does: momentum balance holds whatever the contact is. In one shot alone that is a
/// fault of the measurement. In several it may as well be a force on the ball that the sensor does
/// not take up: the data stay unexplained, and the reason says both.
///
/// Repeats that differ are not of them, for a ball may change from shot to shot.
/// Valid:   plate at rest, or one that a fitted model has.
/// Limit:   a shot with a gain of its own that no fit has seen is a fault; a gain of all shots that
///          explains nothing is none
///          -> tests SuspectedFaultTest.AShotAgainstItsImpulseIsAFault,
///             SuspectedFaultTest.AllShotsAgainstTheirImpulseAreUnexplained.
/// Errors:  as JointModel.
void suspect_what_contradicts_momentum(Diagnosis& diagnosis, const Observations& all);

}  // namespace rebound
