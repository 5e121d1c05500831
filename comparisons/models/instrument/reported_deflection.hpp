#pragma once

#include <span>
#include <vector>

#include "comparisons/models/instrument/measurement_chain.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The deflection of a contact as an instrument of its own reports it, without noise.
///
///   x_reported(t) = (1 + h) x(u) + z,   u = (t − t_s)/(1 + s)
///
///   h, z   gain error and zero of the deflection [-], [m]
///   t_s, s trigger shift and error of the time base, as in reported_force.hpp: one recorder
///   x      before first touch and after separation that of a ball in free flight, with the
///          slopes of the trace at its ends [m]
///
/// Error: cubic between the samples of the trace
///        -> test ReportedDeflectionTest.BetweenSamplesItIsCubic.
/// Limit: an ideal chain returns the trace at its own instants, and straight lines outside
///        -> test ReportedDeflectionTest.IdealChainChangesNothing.
/// Caution: filters of the force channel are not in the deflection's.
/// Errors: Error(bad_input) for a trace of fewer than two samples, or a chain out of its limits.
std::vector<double> reported_deflection(const Trace& contact, const MeasurementChain& chain,
                                        std::span<const double> time);

}  // namespace rebound
