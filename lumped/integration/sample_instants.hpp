#pragma once

#include <cstddef>
#include <span>

#include "lumped/problem/lumped_problem.hpp"

/// When a contact is sampled.
namespace rebound {

/// Samples of a trace: those that are asked for, and more near both ends where that is asked.
std::size_t sample_count(const LumpedControls& controls);

/// Instants of the samples, both ends of [0, T] among them.
///
///   t_i = i Δ,   Δ = T/(samples − 1)
///   finer ends: in the first and the last four Δ, at 4 Δ (k/24)³, k = 0 … 24, from that end
///
/// A force begins as a power of time: t^{3/2} on a sphere, t^{1/4} with Tsuji's damper, at once
/// with a dashpot. No polynomial between samples at equal times follows all of them. The cubes lie
/// close enough to follow any: of 201 samples a cubic between them misses (t/T)^{1/4} by 1.3e-4,
/// and by more than 1e-2 where they are even -> test ReportedForceTest.FinerEndsFollowAnyPower.
///
/// Shape:  `time` as sample_count().
/// Valid:  samples as LumpedControls::limits() has them.
void fill_sample_instants(double contact_time, const LumpedControls& controls,
                          std::span<double> time);

}  // namespace rebound
