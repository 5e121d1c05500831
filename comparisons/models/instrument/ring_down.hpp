#pragma once

#include "lumped/problem/plate.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The trace of a contact on a plate that moves, carried on after the ball has
/// left: the load cell goes on reading the plate that rings.
///
///   M ÿ + c ẏ + k y = 0,   force k y + c ẏ
///
///   duration   how much longer [s]
///
/// Starts from the displacement column of the trace and its last slope (second
/// order in the sample spacing). A rigid plate, or a trace without the column,
/// is returned as it is.
/// Limit: energy of an undamped plate is kept -> test RingDownTest.KeepsItsEnergy.
Trace with_ring_down(const Trace& contact, const Plate& plate, double duration);

}  // namespace rebound
