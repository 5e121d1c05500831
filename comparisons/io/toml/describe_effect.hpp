#pragma once

#include <string>
#include <vector>

#include "comparisons/io/toml/visitor.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/plate.hpp"

namespace rebound {

/// The members of `[model.plate]`. Mass and damping ratio stand beside a
/// stiffness only; a plate that stands still writes nothing.
void describe(Visitor& visit, Plate& plate);

/// One `[[model.effect]]`: its name, then size and parameters as its card says.
void describe(Visitor& visit, EffectChoice& choice);

/// The list `[[model.effect]]`.
void describe_effects(Visitor& visit, std::vector<EffectChoice>& effects);

}  // namespace rebound
