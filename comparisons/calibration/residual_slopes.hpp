#pragma once

#include <span>
#include <vector>

#include "comparisons/calibration/law_calibration.hpp"

namespace rebound {

/// What the forces of a shot are to be differentiated by: the law's unknowns, and the speed
/// last where it is a nuisance.
std::vector<Direction> directions_of(const ShotUnknowns& unknowns);

/// The law's force at one datum with its slopes in the order of directions_of().
struct VariedDatum {
  double force = 0.0;
  std::span<const double> slopes;
  double rate = 0.0;   ///< dF/dt, for a trigger [N/s]
  double speed = 0.0;  ///< as stated [m/s]
  double sigma = 1.0;
};

/// Appends the row ∂/∂x of [gain F + baseline − F_ref]/σ.
void add_row(const ShotUnknowns& unknowns, const VariedDatum& datum, const RecordErrors& errors,
             std::vector<double>& slopes);

}  // namespace rebound
