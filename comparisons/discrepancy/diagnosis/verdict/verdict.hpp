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

/// Families of the effects of each candidate, as they act there: a memory that fades in a fiftieth
/// of the contact is a damper, of the family 'rate'.
std::vector<FamilySet> families_of_candidates(const Diagnosis& diagnosis);

/// Where the verdict is a family: its formulas that come nearest.
void find_nearest_formulas(Diagnosis& diagnosis);

}  // namespace rebound
