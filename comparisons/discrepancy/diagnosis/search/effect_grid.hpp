#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"

/// At which sizes and further numbers a diagnosis looks at an effect.
namespace rebound {

/// Each of `all` with each of these values of a parameter.
std::vector<EffectChoice> with_each(const std::vector<EffectChoice>& all,
                                    const std::string& parameter,
                                    const std::vector<double>& values);

/// `effect` with every combination of what is tried of its further parameters.
std::vector<EffectChoice> over_parameters(const EffectCard& card, const EffectChoice& effect,
                                          const Observations& seen);

/// How close frequencies of what may ring, and sizes, stand to each other.
enum class GridDetail {
  coarse,  ///< a dozen, evenly over their logarithm; of sizes, every fourfold one
  fine     ///< so that none that the data tell apart falls between two
};

/// Where derivatives are taken: a step from null.
std::vector<EffectChoice> small_effects(const EffectCard& card, const Observations& seen,
                                        GridDetail detail);

/// The same swing at the strengths where searches may start.
std::vector<EffectChoice> stronger_effects(const OscillatorCard& card, const EffectChoice& small,
                                           const Observations& seen);

/// Where searches may start.
std::vector<EffectChoice> finite_effects(const EffectCard& card, const Observations& seen,
                                         GridDetail detail);

/// The points of one kind of grid, of all effects in turn.
template <class Grid>
std::vector<EffectChoice> of_all(const std::vector<std::string>& effects, const Grid& grid) {
  std::vector<EffectChoice> choices;
  for (const std::string& name : effects)
    for (EffectChoice& one : grid(find_effect(name).card)) choices.push_back(std::move(one));
  return choices;
}

}  // namespace rebound
