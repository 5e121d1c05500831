#pragma once

#include "lumped/problem/plate.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The trace of a contact on a plate that moves, carried on after the ball has
/// left: the load cell goes on reading the plate that rings.
///
///   M ÿ + c ẏ + k y = 0,   force k y + c ẏ;   on a frame, both as
///   lumped/mechanisms/moving_plate.hpp
///
///   duration   how much longer [s]
///
/// Starts from the displacement columns of the trace and their last slopes (second
/// order in the sample spacing). A rigid plate, or a trace without the column,
/// is returned as it is.
/// Limit: energy of an undamped plate is kept -> test RingDownTest.KeepsItsEnergy.
Trace with_ring_down(const Trace& contact, const Plate& plate, double duration);

}  // namespace rebound
