#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/design/test_design.hpp"
#include "comparisons/discrepancy/trials/trial_share.hpp"

namespace rebound {

/// What is hidden in synthetic experiments of a plan, and how often.
struct PlannedExperiments {
  int experiments = 100;              ///< of every size
  std::optional<std::string> effect;  ///< this one alone; empty: all that can be found
  std::uint64_t seed = 1;             ///< of the thresholds of every diagnosis
};

/// Experiments with one thing hidden in them: what was predicted, and what was said of them.
struct CountedChance {
  std::string effect;  ///< empty: nothing hidden
  SizeOfChance predicted;
  Share gap;       ///< a gap was said
  Share named;     ///< the effect was named, or stood in the set
  Share family;    ///< its family was said, or stood in the set
  int failed = 0;  ///< diagnoses that ended in an error, left out of the shares
};

/// Makes experiments as the plan says, hides an effect at the sizes of design_chances in them,
/// or nothing, and diagnoses each as `rebound diagnose` does, without FE and without repetitions.
///
/// Every experiment has its own seed, that of the plan plus its place: results are the same bits
/// whatever the number of threads.
///
/// Limit: over three histories gap and name are counted as often as predicted, to 0.1 and what few
///        experiments leave -> test PlannedExperimentsTest.WhatIsPredictedIsCounted. Where two
///        speeds leave an effect nearly whole to the fit they are not: see the folder's README.
/// Errors: Error(bad_input) for an effect that the design has no size of; those of synthesize();
///         Error(interrupted).
std::vector<CountedChance> count_chances(const SynthesisFile& plan, const TestDesign& design,
                                         const PlannedExperiments& wanted,
                                         const RunControl& control = {});

}  // namespace rebound
