#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"

/// Which effects a diagnosis tries in FE, and where their searches may start.
namespace rebound {

/// Named effects that have a form in FE and are not there yet; those that swing are found by their
/// frequency (plates_of_lumped).
std::vector<std::string> effects_of_fem(const std::vector<EffectChoice>& present);

/// Curves over strain and over unloading, and a spectrum of times: where no formula explains the
/// data, a family may.
std::vector<std::string> free_forms_of_fem(const std::vector<EffectChoice>& present);

/// Where a search for an effect may start: its usual size, and ten and a hundred times that where
/// it may be as large; a memory fades in half a contact [s].
std::vector<EffectChoice> starts_in_fem(const EffectCard& card, double contact_time);

}  // namespace rebound
