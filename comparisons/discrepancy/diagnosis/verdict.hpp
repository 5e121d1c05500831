#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Turns what a search found into a verdict: which effects, which candidates,
/// which sizes are excluded, where the gap is, what to measure next.
///
///   agrees             nothing is missing; how large each effect may still be
///   missing            the effects of the one candidate, each with numbers that carry a name
///   family             one candidate whose numbers do not carry a name
///   one-of             several candidates, and the effects that all share
///   measurement-fault  every candidate is of the instrument alone
///   insufficient-data  candidates that no data could have contradicted
///   unexplained        no candidate
void conclude(Diagnosis& diagnosis, const SelectionRules& rules);

/// Puts a weaker verdict in the place of a name, with the reason in words.
void withhold(Diagnosis& diagnosis, DiagnosisVerdict weaker, const std::string& why);

/// What the speed that was kept from every fit says of a verdict that names something, once it
/// has been predicted before and after.
///
///   χ² before not above the noise     the gap does not show there: the family, without a name
///   less than half of it removed      the candidate does not predict: unexplained
///
/// A prediction that is better is no proof of a name; one that is not better is proof against it.
void withhold_what_the_unseen_speed_denies(Diagnosis& diagnosis);

/// An effect that repeated measurements would often not choose again carries no name.
void withhold_what_repetition_denies(Diagnosis& diagnosis, const SelectionRules& rules);

}  // namespace rebound
