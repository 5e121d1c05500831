#pragma once

#include "lumped/problem/result.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// Largest value of a sampled quantity, refined by the parabola through the
/// highest sample and its two neighbours (equally spaced or not).
///
/// Error: third order in the spacing where the quantity is smooth
/// -> test ScalarsTest.ParabolaFindsPeakOfSine.
double refined_peak(const std::vector<double>& time, const std::vector<double>& value);

/// ∫ value dt over the whole trace by the trapezoidal rule. Exact for a trace
/// of interval means placed at the middle of their intervals.
double integral(const std::vector<double>& time, const std::vector<double>& value);

/// Time between the first upward and the last downward crossing of
/// `threshold` [N], crossings interpolated linearly. Zero when never crossed.
double time_above(const std::vector<double>& time, const std::vector<double>& force,
                  double threshold);
/// The same of what the instrument reads.
double time_above(const Trace& trace, double threshold);

/// Force on the ball: the column contact_force_N where it stands, as it does beside the
/// reading of a load cell, else the force.
const std::vector<double>& contact_force(const Trace& trace);

/// Derives the shared scalars of a trace. Those of force are of the contact force, whatever
/// a load cell under the plate reads.
///
///   contact_time       = separation_time
///   contact_time_1pct  = time above 0.01 × (refined peak force)
///   mean_deflection    = ∫₀^T x dt / T
///   restitution        = rebound_speed / approach speed
///
///   separation_time  T, instant found by the tier under `impact.separation` [s]
///   rebound_speed    of the centre of mass at T, away from the plate positive [m/s]
///
/// Limit: a load cell's ringing moves no scalar -> test ScalarsTest.AreOfTheContactForce
/// Errors: Error(bad_input) for fewer than three samples or unequal columns.
ImpactScalars derive_scalars(const Trace& trace, const Impact& impact, double separation_time,
                             double rebound_speed);

}  // namespace rebound
