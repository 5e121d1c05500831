#pragma once

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {

/// Δχ² of the effect that jumps at first touch (`jumps_at_touch` of its card) and brings most, from
/// where the first order has it and at each of the numbers it was tried at.
///
/// Fitted in full where it could pass `limit`: a fit brings up to some four times what the best
/// size does beside starts of records that suit it and unknowns that follow to first order.
/// Limit:  a weak pull under noise with a colour -> test JumpAtTouchTest.AWeakPullIsSeenByAFit.
/// Errors: as fit_extended(), but where an impact has no answer.
double gain_of_jumps(const Observations& seen, const HypothesisFit& fit,
                     const EffectSensitivities& around, double limit);

}  // namespace rebound
