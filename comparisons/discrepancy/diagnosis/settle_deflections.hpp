#pragma once

#include <cstddef>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// A whole record of a shot, by its index among the observations.
struct WholeRecord {
  std::size_t shot = 0;
  const Trace* trace = nullptr;
};

/// Says what the deflections beside the forces of one data set are worth: the deflection noise of
/// each shot, 0 where its deflections are no data.
///
///   independent   data, with the noise as stated or as the samples before contact scatter about
///                 a straight line of each record: a ball that comes nearer is no noise. The colour
///                 is that of those samples; a stated size that they contradict is replaced
///   integrated    the force once more: not used, and said
///   unknown       not used, and said
///
/// Without a stated noise and without samples before contact deflections are not used, and said.
/// Where the scale is not stated, 1 % is assumed, with a warning.
void settle_deflections(const Dataset& dataset, const std::vector<WholeRecord>& records,
                        Observations& seen);

}  // namespace rebound
