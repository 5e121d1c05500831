#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"

namespace rebound {

/// One effect more in a fitted model, and what of the data it explains.
struct EffectOnScalars {
  EffectChoice effect;  ///< with fitted numbers
  EffectFamily family{};
  double chi_square = 0.0;  ///< with priors
  double reduced_chi_square = 0.0;
  double information_criterion = 0.0;
};

/// The eight effects that promise most, one at a time, from the best start of their grids; those
/// that bring the model closer, best criterion first. The best two are searched to the end.
///
/// Limit:  data of the model with one effect: that effect is first
///         -> test EffectsOnScalarsTest.TheEffectThatIsThereComesFirst.
/// Errors: Error(interrupted); effects without an answer are left out.
std::vector<EffectOnScalars> try_effects(const Observations& seen, const HypothesisFit& believed,
                                         const RunControl& control = {});

}  // namespace rebound
