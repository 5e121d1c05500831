#pragma once

#include "lumped/problem/trace.hpp"

namespace rebound {

/// A force behind a first-order high-pass, as a charge amplifier with a finite time constant
/// passes it.
///
///   ẏ = Ḟ − s y,   y_{i+1} = e^{−sh} y_i + (F_{i+1} − F_i) (1 − e^{−sh})/(sh)
///
///   s   rate, one over the time constant [1/s]
///   h   distance of two samples, each its own [s]
///
/// Exact for a force that is linear between its samples and starts from rest with its first.
/// After the last sample the force is zero and y goes on to `last`: the undershoot by which a
/// drooping record is known.
/// Limit:   s = 0 returns the force -> test DroopTest.WithoutARateNothingChanges; a step decays
///          as e^{−st} -> test DroopTest.AStepDecaysByTheTimeConstant.
/// Source:  Serridge & Licht, Piezoelectric Accelerometers and Vibration Preamplifiers (Bruel &
///          Kjaer 1987), lower limiting frequency; the recursion by integration of the equation.
Trace with_droop(const Trace& force, double rate, double last);

}  // namespace rebound
