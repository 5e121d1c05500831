#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {

/// The largest size of an effect that the data leave possible (95 %, one side).
struct ExcludedSize {
  std::string name;
  double size = 0.0;  ///< distance from the size at which the effect is absent, SI
  /// Ranges of its further parameters for which this holds.
  struct Over {
    std::string parameter;
    double lowest = 0.0, highest = 0.0;
  };
  std::vector<Over> over;
};

/// Sizes that a fitted model which agrees with its data excludes.
///
///   χ²(size) − χ²(null) ≥ 2.71 once the fit's own unknowns have taken what they can
///
/// at every point of a grid over the effect's further parameters, and for either sign where
/// both are possible: what is stated is the size at which the effect shows least.
///
/// Valid:   the model agrees with the data. First order in the fit's unknowns, exact in the effect.
/// Limit:   an effect hidden at a size that noise covers is not excluded
///          -> test NotFooledTest.ExcludedSizesCoverTheTruth.
/// Effects that stay hidden somewhere on the grid at eight times their prior scale, switches, and
/// effects without a size of null are left out.
std::vector<ExcludedSize> excluded_sizes(const EffectSensitivities& around);

}  // namespace rebound
