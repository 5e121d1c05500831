#pragma once

#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"

namespace rebound {

/// What the forces of a shot are to be differentiated by: the law's unknowns, then what its
/// nuisances move of the impact, one direction a nuisance.
std::vector<Direction> directions_of(const ShotUnknowns& unknowns);

/// Appends the row ∂/∂x of [(1 + g) F + b − F_ref]/σ.
void add_row(const ShotUnknowns& unknowns, const DatumWithSensitivities& datum,
             const MeasurementChain& chain, std::vector<double>& slopes);

/// The law's force as the chain reports it, its start and bandwidth aside [N].
inline double reported(double force, const MeasurementChain& chain) {
  return (1.0 + chain.force_gain) * force + chain.force_baseline;
}

}  // namespace rebound
