#pragma once

#include <span>
#include <vector>

#include "comparisons/models/instrument/measurement_chain.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The force of a contact as the chain reports it, without noise.
///
///   F_reported(t) = min[(1 + g) F(u) + added(u), L],   u = (t − t_s)/(1 + s)
///
///   F      behind the filters of the chain: low-pass (butterworth.hpp), droop (droop.hpp), class
///          of SAE J211 (channel_filter.hpp)
///   added  baseline, drift, hum and burst (disturbance.hpp) [N]
///   t_s    trigger shift: first touch by the recorder's clock [s]
///   s      by which the recorder's clock runs fast, counted from first touch [-]
///   L      level at which the amplifier saturates [N]
///   time   instants, increasing; a reading is the mean of F over the aperture of the chain where
///          the contact ends within it, but for a jump there; before first touch and after
///          separation the contact force is zero [s]
///
/// Error: cubic between the samples of the trace, so that reports of well-resolved contacts change
///        smoothly with the trigger: below 1e-6 of the peak at 200 samples, and (h²/8) max|F''|
///        where the force bends sharply; a force that jumps at first touch keeps its jump
///        -> test ReportedForceTest.BetweenSamplesItIsCubic.
/// Limit: an ideal chain returns the trace at its own instants
///        -> test ReportedForceTest.IdealChainChangesNothing; an aperture takes the bend from the
///        end of a contact -> test ReportedForceTest.AnApertureTakesTheKinkFromAnEnd.
/// Caution: a cut-off above 0.45 of the trace's own sampling rate passes all: what it would
///        change, a delay of less than the sample spacing, lies between the samples.
/// Errors: Error(bad_input) for a trace of fewer than two samples, or a chain out of its limits.
std::vector<double> reported_force(const Trace& contact, const MeasurementChain& chain,
                                   std::span<const double> time);

}  // namespace rebound
