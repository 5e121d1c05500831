#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Turns what a search found into a verdict: which effects, which candidates,
/// which sizes are excluded, where the gap is, what to measure next.
///
///   agrees             nothing is missing; how large each effect may still be
///   missing, one-of    the effects of one candidate, or those that all share
///   measurement-fault  every candidate is of the instrument alone
///   unexplained        no candidate, or one that no data could have contradicted
void conclude(Diagnosis& diagnosis, const SelectionRules& rules);

}  // namespace rebound
