#pragma once

#include "lumped/problem/trace.hpp"

namespace rebound {

/// A force behind a first-order lag, as a sensor or an amplifier with one dominant pole passes it.
///
///   τ ẏ = F − y,   y_{i+1} = e^{−x} y_i + F_i (m − e^{−x}) + F_{i+1} (1 − m),
///   x = h/τ,   m = (1 − e^{−x})/x
///
///   τ   time constant [s]
///   h   distance of two samples, each its own [s]
///
/// Exact for a force that is linear between its samples and starts from rest. After the last sample
/// the force is zero and y goes on to `last`.
/// Limit:   τ = 0 returns the force -> test LagTest.WithoutATimeNothingChanges; a ramp comes τ late
///          -> test LagTest.ARampComesLateByTheTimeConstant.
/// Source:  integration of the equation over one step.
Trace with_lag(const Trace& force, double time_constant, double last);

}  // namespace rebound
