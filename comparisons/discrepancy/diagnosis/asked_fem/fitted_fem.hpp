#pragma once

#include <cstddef>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

/// A ball in FE, fitted to the histories of some shots.
struct FittedFem {
  Material material;
  std::vector<EffectChoice> effects;  ///< with fitted numbers
  double chi_square = 0.0;            ///< Σ r² over histories and priors
  std::size_t samples = 0;            ///< of the histories
  double effect_unknowns = 0.0;       ///< fitted numbers of the effects
};

}  // namespace rebound
