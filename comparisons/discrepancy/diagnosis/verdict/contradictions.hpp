#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Contradictions among the data that `fit`, one of a diagnosis, does not show as well.
///
/// The model's own records, without noise and with nothing wrong in gain, mass and speeds, go
/// through the same checks with the same errors: a plate on its load cell moves impulse and energy
/// by what it takes, and a fault that the model holds explains what it does. A contradiction is
/// left where it differs by more than the limit and a quarter of what is explained.
///
/// Limit:  a model without faults explains none
///         -> test ContradictionsTest.AModelWithoutAFaultExplainsNone.
/// Errors: as JointModel.
std::vector<DataCheck> unexplained_contradictions(const Diagnosis& diagnosis,
                                                  const HypothesisFit& fit,
                                                  const Observations& all);

/// A physical name is withheld where the data contradict themselves and the named model does not
/// say why.
void withhold_names_from_contradictions(Diagnosis& diagnosis, const Observations& all);

/// Where the force changes before the first touch, neither the believed model nor an effect of the
/// contact is all there is: unexplained, unless a fault is said that acts before the touch, too.
void withhold_what_acts_before_touch(Diagnosis& diagnosis);

}  // namespace rebound
