#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/record_numbers.hpp"
#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// A shot with what its record says by itself; nothing is known of a shot without a record.
struct CheckedShot {
  const MeasuredImpact* shot = nullptr;
  RecordReadings readings{};

  const RecordReading& reading(RecordNumber number) const { return reading_of(readings, number); }
};

/// All shots, whose records must outlive this.
std::vector<CheckedShot> checked_shots(const Observations& seen);

/// Impulse of gravity over the contact, m g T: nothing says whether it acts along the impact [N s].
double gravity_impulse(const CheckedShot& one);

/// A number with its error.
struct Ratio {
  double value = 1.0;
  double error = 0.0;
};

/// Numbers that should be one and the same, their weighted mean without those that stand apart,
/// and the mean of the others for each of them.
///
/// The one that deviates most from the mean of the others goes first, as long as it does so by more
/// than three standard deviations and more than two would be left.
struct OddOnes {
  Ratio mean;
  std::vector<Ratio> mean_of_others;
  std::vector<bool> odd;
};
OddOnes set_odd_ones_apart(const std::vector<Ratio>& ratios);

}  // namespace rebound
