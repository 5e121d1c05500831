#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
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

/// What FE's own ball with nothing hidden is made of, and the plate that it has found under it:
/// "neo-Hookean, E 12.3 MPa, ν 0.41, branch 0.52 in 21 µs". E is long-term, a branch is over it.
std::string fem_ball_in_words(const FittedFem& ball);

/// One sentence for every ball that FE was fitted to.
std::vector<std::string> fem_balls_in_words(const Diagnosis& diagnosis);

/// Do the tiers say the same of an effect? "agree", "differ", "FE alone" for an effect without a
/// lumped form, "FE cannot say" where FE follows the data neither way.
std::string tiers_together(const EffectInFem& effect);

/// The effects that FE was asked of, four at most, with the verdict and the gaps of each tier.
report::Table tiers_table(const Diagnosis& diagnosis);

}  // namespace rebound
