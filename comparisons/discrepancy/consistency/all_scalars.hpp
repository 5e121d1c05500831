#pragma once

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Errors of what a data set states without one, as shares of the value, one standard deviation.
struct AssumedErrors {
  double mean_deflection = 0.05;  ///< of a double integral of force over mass [-]
  double pooled_peak = 0.15;      ///< of a peak that stands for several balls [-]
};

/// Every scalar that a data set states of its shots, each with an error: restitution, contact time,
/// mean deflection, and the peaks that are typical of several balls at the speed of a shot.
///
/// A mean deflection counts although it was integrated from the force: where no history is given,
/// it tells of the pulse what restitution and contact time do not.
///
/// Errors: as observe().
Observations all_scalars(const Dataset& data, const AssumedErrors& assumed);

}  // namespace rebound
