#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// What a new measurement would record.
enum class RecordedQuantity {
  force,       ///< over time, of an impact
  deflection,  ///< over time, of an impact, by an instrument of its own
  slow_force   ///< over deflection, of a compression in ten seconds
};

/// One record that was not taken, on the ball and the instrument of a shot that was.
struct PlannedRecord {
  RecordedQuantity quantity = RecordedQuantity::force;
  std::size_t like = 0;  ///< that shot
  double speed_factor = 1.0;
  double mass_factor = 1.0;
};

/// A measurement that could be made next.
struct PlannedExperiment {
  std::string what;
  std::vector<PlannedRecord> records;
  int repeats = 1;  ///< of every record
};

/// What a laboratory could do next with the balls and the instrument of these data:
///
///   a force history at 0.3 times the slowest and at 1.6 times the fastest speed
///   a ball of twice the mass on the same contact
///   four further hits at every speed that has a history
///   deflection beside the force at the fastest speed, where none was measured
///   a slow compression to the deflection of the fastest impact, where there is none
///   force histories at the slowest and fastest speed, where only scalars were taken
///
/// Not among them: holding a compressed ball, since no lumped model is run that way.
std::vector<PlannedExperiment> possible_experiments(const Observations& seen);

}  // namespace rebound
