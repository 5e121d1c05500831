#pragma once

#include <vector>

#include "comparisons/models/effects/effect.hpp"

namespace rebound {

struct HypothesisFit;

/// Of what effects beside the law explain FE's ball must take as much, or its part in the model is
/// worth no search.
inline constexpr double share_worth_a_search = 0.5;

/// What the lumped tier has said of the data when FE is asked.
struct LumpedAnswer {
  const HypothesisFit& law;  ///< the believed law, fitted
  /// Where a plate on its load cell may be looked for in FE.
  std::vector<EffectChoice> plates;
  /// That law with the effects that explain the data, on a rigid plate; null where none do.
  const HypothesisFit* explanation = nullptr;
};

}  // namespace rebound
