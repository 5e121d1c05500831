#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/next_experiment/separation.hpp"

namespace rebound {

/// An experiment that would tell candidates apart.
struct NextExperiment {
  std::string what;                    ///< in words
  std::vector<std::string> separates;  ///< the two candidates, effects joined by " + "
  double probability = 0.0;  ///< that the right one, whichever it is, then rules the other out
};

/// The probability that a rival is ruled out after an experiment that goes as `truth` says.
///
///   P = Φ[(Δχ² + d − c)/(2 √Δχ²)]
///
///   Δχ²   of expected_separation(): the rival is fitted again
///   d     lead of the truth in the information criterion on the data at hand
///   c     the close criterion: the lead that rules a rival out
///
/// Limit: the share of experiments after which it is so -> test
///        NextExperimentTest.ThePredictedChanceIsTheShareThatIsSeen.
/// Errors: as expected_separation().
double chance_that_truth_wins(const Observations& seen, const HeldFit& truth, const HeldFit& rival,
                              const PlannedExperiment& experiment, double close_criterion);

/// Ranks what could be measured next (possible_experiments) by how well it tells each pair of
/// candidates apart: the smaller of the chances with the one and the other as the truth.
///
/// Caution: each candidate stands for the truth with its fitted numbers; how sure these are is
///          not in the chance.
std::vector<NextExperiment> next_experiments(const Observations& seen,
                                             const std::vector<const HypothesisFit*>& candidates,
                                             double close_criterion);

/// Names of the effects of a fit, joined by " + ".
std::string label_of(const std::vector<EffectChoice>& effects);

}  // namespace rebound
