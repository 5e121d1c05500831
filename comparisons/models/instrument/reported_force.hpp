#pragma once

#include <span>
#include <vector>

#include "comparisons/models/instrument/measurement_chain.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The force of a contact as the chain reports it, without noise.
///
///   F_reported(t) = (1 + g) F(t − t_s) + b,   F filtered where the bandwidth is finite
///
///   time   instants, increasing; before first touch and after separation the
///          contact force is zero [s]
///
/// Error: linear between the samples of the trace, (h²/8) max|F''|: 1e-5 of the
///        peak at 400 samples; a force that jumps at first touch keeps its jump.
/// Limit: an ideal chain returns the trace at its own instants
///        -> test ReportedForceTest.IdealChainChangesNothing.
/// Errors: Error(bad_input) for a trace of fewer than two samples, or a
///         bandwidth above half the trace's own sampling rate.
std::vector<double> reported_force(const Trace& contact, const MeasurementChain& chain,
                                   std::span<const double> time);

}  // namespace rebound
