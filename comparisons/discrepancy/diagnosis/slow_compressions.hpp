#pragma once

#include <cstddef>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Collects what a data set measured beside impacts: slow compressions, block moduli, pooled peaks.
///
/// Of a curve the way in counts, by the means of eight stretches of deflection between a fifth of
/// the largest and all of it; where impacts have histories, no further than 1.2 v T/2.94, the
/// deflection of a Hertz contact of that speed and duration: beyond, an elastic law was not seen at
/// work. Each mean has the stated force_uncertainty, or 5 %, with a warning. A stiffness κ is one
/// point of κ x^1.5, at half of that reach or at a twentieth of the diameter. Without a stated
/// uncertainty it is compared only, as known to 5 %.
/// A loading of unknown duration is taken to last 10 s.
void add_slow_tests(const Dataset& dataset, std::size_t ball, Observations& seen);

}  // namespace rebound
