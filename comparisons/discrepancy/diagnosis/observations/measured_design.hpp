#pragma once

#include <vector>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// What an experiment is like: how many speeds, and how noisy its records of force are.
struct MeasuredDesign {
  int speeds = 0;  ///< different ones, as well as they are known
  /// Of single readings, one deviation over the smallest peak force; 0: no records, or their noise
  /// is unknown. [-]
  double noise_share = 0.0;
};

/// Of data sets, and of the observations that were made of them.
MeasuredDesign measured_design(const std::vector<Dataset>& datasets, const Observations& all);

}  // namespace rebound
