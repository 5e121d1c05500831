#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"

namespace rebound {

/// An experiment that would tell candidates apart.
struct NextExperiment {
  std::string what;                    ///< in words
  std::vector<std::string> separates;  ///< the two candidates, effects joined by " + "
  double probability = 0.0;            ///< that the right one then wins by the close criterion
};

/// Ranks experiments by how well they separate each pair of candidates.
///
///   Δχ² = min over nuisances of Σ [(A − B)/σ]²,   P = Φ[(Δχ² − c)/(2 √Δχ²)]
///
///   A, B   what the two fitted candidates predict for the new shot
///   c      the close criterion: the lead that rules a rival out
///
/// Tried: force histories at slower and faster speeds than those at hand, a
/// ball of twice the mass on the same contact, and force histories where only
/// scalars were taken.
/// Caution: the candidates are held at their fitted numbers; a refit would
///          bring them closer, so P is an upper bound.
std::vector<NextExperiment> next_experiments(const Observations& seen,
                                             const std::vector<const HypothesisFit*>& candidates,
                                             double close_criterion);

/// Names of the effects of a fit, joined by " + ".
std::string label_of(const std::vector<EffectChoice>& effects);

}  // namespace rebound
