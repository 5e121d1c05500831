#pragma once

#include <string>
#include <vector>

#include "fem/interface/compression.hpp"
#include "fem/interface/fem_result.hpp"

namespace rebound {

/// A trace as CSV with 17 significant digits: time_s, force_N, deflection_m
/// where there is one, then whatever further columns it has.
std::string trace_csv(const Trace& trace);

/// The same with one column per energy, in J.
/// Errors: Error(solver_failed) when trace and energies differ in length.
std::string trace_csv(const Trace& trace, const std::vector<EnergyBalance>& energies);

/// A compression: time_s where the path has one, deflection_m, force_N,
/// contact_radius_m, stored_J, work_J. A slow one is what a data set takes as
/// a quasi-static trace.
std::string curve_csv(const CompressionCurve& curve);

}  // namespace rebound
