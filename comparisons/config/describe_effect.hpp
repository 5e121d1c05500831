#pragma once

#include <string>
#include <vector>

#include "comparisons/config/visitor.hpp"
#include "comparisons/effects/effect.hpp"
#include "lumped/problem/plate.hpp"

namespace rebound {

/// The members of `[model.plate]`. Mass and damping ratio stand beside a
/// stiffness only; a plate that stands still writes nothing.
void describe(Visitor& visit, Plate& plate);

/// One `[[model.effect]]`: its name, then size and parameters as its card says.
void describe(Visitor& visit, EffectChoice& choice);

/// Unit in which the size of an effect is written; empty for a plain number. A work per
/// area reads J/m^2, where a stiffness of the same dimension reads N/m.
std::string size_unit(const EffectCard& card);

/// The list `[[model.effect]]`.
void describe_effects(Visitor& visit, std::vector<EffectChoice>& effects);

}  // namespace rebound
