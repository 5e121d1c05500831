#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// The six effects that promise most, one at a time, from the best start of their grids; those
/// that bring the model closer, best criterion first. The best two are searched to the end.
///
/// Limit:  data of the model with one effect: that effect is first
///         -> test EffectsOnScalarsTest.TheEffectThatIsThereComesFirst.
/// Errors: Error(interrupted); effects without an answer are left out.
/// Caution: the fits look at `seen`, which must outlive them.
std::vector<HypothesisFit> try_effects(const Observations& seen, const HypothesisFit& believed,
                                       const RunControl& control = {});

}  // namespace rebound
