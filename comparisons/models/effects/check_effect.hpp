#pragma once

#include <string>

#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// The choice with the card's defaults for parameters it leaves out.
///
/// `path` is the key path of the choice, for errors.
/// Errors: Error(bad_input) for a size or parameter out of range (the null size
/// is always allowed), or a parameter that the card does not have.
EffectChoice checked_choice(const EffectCard& card, const EffectChoice& choice,
                            const std::string& path);

}  // namespace rebound
