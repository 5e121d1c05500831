#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/selection.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"

/// Plates that a lumped search has found, as FE has them: a mass on its load cell. Of one on a
/// frame, which FE has not, the plate alone.
namespace rebound {

/// Is it a plate under the ball, alone or on a frame? A mass within the ball swings, too, and is
/// none. Limit:  an inner mode is none -> test PlatesOfLumped.AMassWithinTheBallIsNoPlate
bool is_plate(const std::string& effect);

/// That of the best fit with a plate, beside whatever effects, and that of the best fit with a
/// plate alone, at every strength; none where no fit holds one. Limit:  a plate on a frame gives
/// the plate on it -> test PlatesOfLumped.OneOnAFrameIsTakenOutOfIt
std::vector<EffectChoice> plates_found(const EffectSelection& found, const Observations& seen);

/// Those, where a plate alone takes half of the gap.
std::vector<EffectChoice> plates_worth_a_search(const EffectSelection& found,
                                                const Observations& seen);

}  // namespace rebound
