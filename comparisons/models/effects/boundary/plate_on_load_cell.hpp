#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

/// A plate that is a mass on the spring of its load cell: what the effects that contain one share.
namespace rebound {

/// The numbers of it beside its compliance, which is the size of the effect.
inline std::vector<EffectParameterCard> plate_parameters(const std::string& damping_sentence) {
  return {{.name = "mass",
           .sentence = "Mass of the plate.",
           .dimension = dimension::mass,
           .range = limit_of<&Plate::mass>.range,
           .default_value = 2.0,
           .fitted = true},
          {.name = "damping_ratio",
           .sentence = damping_sentence,
           .dimension = dimension::none,
           .range = limit_of<&Plate::damping_ratio>.range,
           .default_value = 0.02,
           .fitted = true,
           .tried = {0.02}}};
}

/// The plate of a model, set on the load cell of an effect.
/// Errors: Error(bad_input) for a plate that moves before.
inline Plate plate_on_load_cell(const EffectChoice& choice, const Plate& before) {
  if (before.moves())
    throw Error(ExitCode::bad_input,
                "'" + choice.name +
                    "' needs a plate that stands still before; give the stiffness in "
                    "[model.plate] or by the effect");
  Plate plate = before;
  plate.stiffness = 1.0 / choice.size;
  plate.mass = choice.parameters.at("mass");
  plate.damping_ratio = choice.parameters.at("damping_ratio");
  return plate;
}

}  // namespace rebound
