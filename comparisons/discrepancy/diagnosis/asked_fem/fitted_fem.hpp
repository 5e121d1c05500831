#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

/// Reduced χ² that FE may leave of data that it follows: its errors are known to a factor.
inline constexpr double left_by_fem = 1.5;
/// Reduced χ² beyond which a ball is searched for no further: something else is wrong than where
/// the search has ended.
inline constexpr double far_from_data = 300.0;

/// Does one of these act as soon as there is contact, and not as the contact grows?
inline bool act_on_the_surface(const std::vector<EffectChoice>& effects) {
  return std::any_of(effects.begin(), effects.end(), [](const EffectChoice& one) {
    return find_effect(one.name).card.family == EffectFamily::surface;
  });
}

/// A ball in FE, fitted to the histories of some shots.
struct FittedFem {
  Material material;
  std::vector<EffectChoice> effects;  ///< with fitted numbers
  std::vector<double> records;        ///< unknowns of RecordsOfShots, as they were fitted
  double chi_square = 0.0;            ///< Σ r² over histories and priors
  std::size_t samples = 0;            ///< of the histories
  double effect_unknowns = 0.0;       ///< fitted numbers of the effects

  /// Of the force, as it was fitted [-].
  double gain() const { return records.empty() ? 0.0 : records.front(); }
  bool is_far() const { return chi_square > far_from_data * static_cast<double>(samples); }
  bool follows() const { return chi_square <= left_by_fem * static_cast<double>(samples); }
};

}  // namespace rebound
