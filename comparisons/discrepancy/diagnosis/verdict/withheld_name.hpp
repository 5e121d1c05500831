#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

/// What takes a name back that a search had found.
namespace rebound {

/// Is the one candidate a set of two effects, of two families, neither a fault of the measurement?
/// Data that a pair of families explains are not unexplained. The repair of a formula is no effect.
bool is_of_two_families(const Diagnosis& diagnosis);

/// What is left of a verdict that has lost its name: its family, where it has one, or two.
DiagnosisVerdict without_name(const Diagnosis& diagnosis);

/// A weaker verdict, and why; the repair of a formula that contradicts its own restitution stays.
void withhold(Diagnosis& diagnosis, DiagnosisVerdict weaker, const std::string& why);

/// Nothing of what a search has found stands: the believed model is the best there is.
void drop_candidates(Diagnosis& diagnosis);

/// What the speed that was kept from every fit says of a verdict that names something, once it
/// has been predicted before and after.
///
/// - χ² before, or after, within the noise: no gap shows there; the family, without a name.
/// - Neither, and less than half removed: the candidate does not predict; unexplained.
/// - A fault of all shots, and χ² rises by more than comes close: it would be there, too;
///   unexplained.
/// - χ² before within the noise, not better after, of a gap that noise could make, with rivals of
///   several families: the believed model stands.
/// - χ² before within the noise, and that of the fit within its errors, FE's own among them: the
///   believed model stands.
///
/// A prediction that is better is no proof of a name; one that is not better is proof against it.
void withhold_what_the_unseen_speed_denies(Diagnosis& diagnosis, const SelectionRules& rules);

/// An effect that repeated measurements would often not choose again carries no name.
void withhold_what_repetition_denies(Diagnosis& diagnosis, const SelectionRules& rules);

}  // namespace rebound
