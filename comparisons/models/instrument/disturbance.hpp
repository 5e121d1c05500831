#pragma once

#include "comparisons/models/instrument/measurement_chain.hpp"

namespace rebound {

/// What the chain adds to the force, whatever the force is.
///
///   b + d u + A sin(2π f u + φ) + burst(u)
///
///   u   time since first touch, below zero before it [s]
///
/// Drift is a straight line through the baseline at first touch, before and after it: a zero
/// that wanders does not wait for the ball.
/// Caution: hum has one phase at first touch for all shots. A mains hum that is not locked to
///          the trigger has another phase in every shot.
/// Limit:   zero amplitudes and drift leave the baseline, bit for bit
///          -> test DisturbanceTest.NothingIsAddedByDefault.
/// Source:  superposition of a measured signal and its disturbances.
double added_force(const MeasurementChain& chain, double since_touch);

}  // namespace rebound
