#pragma once

#include <optional>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// Shots that were made at one speed, as well as the speed was known.
struct SpeedCluster {
  double speed = 0.0;              ///< mean of its shots [m/s]
  std::vector<std::size_t> shots;  ///< indices
};

/// Shots ordered by speed and parted where two neighbours differ by more than three standard
/// deviations of their difference and by more than a fiftieth: measured speeds of 14.89, 14.96
/// and 14.97 m/s are one speed.
std::vector<SpeedCluster> speed_clusters(const Observations& all);

/// The cluster that is kept from every fit: the one that holds `wanted`, or else the middle one
/// of three or more; nothing where there are fewer.
/// Errors: Error(bad_input) where no cluster holds `wanted`.
std::optional<SpeedCluster> choose_held_out(const Observations& all, std::optional<double> wanted);

/// Shots that are fitted, and those that no fit sees.
struct PartedShots {
  Observations seen, unseen;
};

/// All shots in two parts: those of a cluster of speeds, and all others, which keep the slow
/// compressions. Without a cluster all of them are fitted.
PartedShots part_at(const Observations& all, const std::optional<SpeedCluster>& held_out);

}  // namespace rebound
