#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

/// What is said where one shot is not like the others, or each is not like the one before it.
namespace rebound {

/// Takes out of the candidates what holds a ball that changes from shot to shot, where others do
/// without: where shots come in the order of their speeds, much looks like it.
void prefer_a_ball_that_stays(Diagnosis& diagnosis);

/// A ball that changes from shot to shot is none of which a model could speak: unexplained, with
/// the change in words. So is a single shot that is scaled in force and time, each in its own way,
/// where no other has its speed: a fault of that shot is not told from what begins at that speed,
/// or comes with the order of shots. `all`: the shots of all speeds. The candidates stay.
///
/// Limit:  -> tests ShotsThatDifferTest.ABallThatChangesIsUnexplained,
///            ShotsThatDifferTest.AnOddShotWithoutARepeatIsNoFault
void withhold_what_shots_alone_explain(Diagnosis& diagnosis, const Observations& all);

}  // namespace rebound
