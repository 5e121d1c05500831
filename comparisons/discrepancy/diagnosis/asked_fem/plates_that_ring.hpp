#pragma once

#include <vector>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Plates from which a search in FE may start, where a fault of the measurement that swings, as a
/// hum or a burst, was fitted to data of FE: at its frequency, of several masses.
///
/// A search for FE's own ball on a rigid plate gives the material a part of what a plate does, so
/// that beside it no plate looks right; what rings on after the contact is no material's.
/// Empty where the fault does not swing.
std::vector<EffectChoice> plates_that_ring(const EffectChoice& fault, const Observations& seen);

}  // namespace rebound
