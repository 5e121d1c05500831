#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"

namespace rebound {

/// Of every effect the start that promises most to first order beside FE with nothing hidden, moved
/// to the size where it gains most; best first. A fault of the measurement acts on records alone,
/// so that all its numbers are searched. Those alone that are worth a fit, and of physical effects
/// and of faults the four best each: faults are many, and must not take all places.
///
/// Errors: those of FirstOrderOfBalls.
std::vector<EffectChoice> promising_effects(const StartsOfEffects& starts,
                                            const FirstOrderOfBalls& around,
                                            const RunControl& control);

}  // namespace rebound
