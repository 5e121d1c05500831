#pragma once

#include <vector>

#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"

namespace rebound {

/// Balls that were fitted apart, as those of one model: what was seen of all, what was not, and
/// each ball's own believed FE model.
struct BallsTogether {
  Observations seen, unseen;
  std::shared_ptr<const FemBelief> fem;
};
BallsTogether put_together(const std::vector<const FitsOfEffects*>& apart);

/// An effect at the size at which it is not there.
EffectChoice absent(const std::string& name);

/// One effect between those of several balls: means of sizes and of fitted numbers, geometric ones
/// where a fit looks for logarithms; all else as the first has it.
EffectChoice middle_of(const std::vector<EffectChoice>& choices);

/// All balls with one effect, each with its own material, speeds and mass, by one search from these
/// numbers of the effect and from what `apart` has fitted of everything else.
///
/// Limit:  where each ball has its own size and nothing else is in common, the fits apart
///         -> test JointScalarsTest.SizesOfEachBallAreThoseApart.
/// Errors: as fit_further(). Caution: the fit looks at `balls`, which must outlive it.
HypothesisFit fit_together(const BallsTogether& balls,
                           const std::vector<const HypothesisFit*>& apart,
                           const EffectChoice& start, const RunControl& control);

/// One ball alone, by a search from what a fit of all balls has found of it.
/// Errors: as fit_further(). Caution: the fit looks at what was seen of `own`.
HypothesisFit fit_alone(const FitsOfEffects& own, const HypothesisFit& all, std::size_t ball,
                        const BallsTogether& balls, const RunControl& control);

}  // namespace rebound
