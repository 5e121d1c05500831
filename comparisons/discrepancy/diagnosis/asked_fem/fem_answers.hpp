#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/table.hpp"

/// What FE was asked beside a lumped belief, and what it said, for readers.
///
/// Gaps stand here as root mean square residuals in standard deviations of the data, the roots of
/// the reduced whitened χ²: noise alone leaves 1.
namespace rebound {

/// One or two sentences: what FE leaves with nothing hidden, or what it says of each name; empty
/// where FE was not asked.
std::string fem_sentence(const Diagnosis& diagnosis);

/// Do the tiers say the same of an effect? "agree", "differ", "FE alone" for an effect without a
/// lumped form, "FE cannot say" where FE follows the data neither way.
std::string tiers_together(const EffectInFem& effect);

/// The effects that FE was asked of, four at most, with the verdict and the gaps of each tier.
report::Table tiers_table(const Diagnosis& diagnosis);

}  // namespace rebound
