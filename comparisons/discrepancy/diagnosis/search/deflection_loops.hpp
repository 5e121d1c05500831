#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// The loop of force over deflection of one shot, at the instants of its record.
struct DeflectionLoop {
  std::vector<double> deflection;  ///< of the fitted model, m; empty where no force was read
  std::size_t top = 0;             ///< sample of the largest deflection
  std::size_t first_row = 0;       ///< of its force among the residuals

  bool measured() const { return !deflection.empty(); }
  double deepest() const { return deflection[top]; }
  bool loads_at(std::size_t sample) const { return sample <= top; }
};

/// One loop a shot.
std::vector<DeflectionLoop> deflection_loops(const Observations& seen, const HypothesisFit& fit);

/// The largest deflection of some shots, m; 0 where none has a force history.
double deepest_of(const std::vector<DeflectionLoop>& loops, const std::vector<std::size_t>& shots);

/// A force, N, at one sample of a loop.
using ForceOnLoop = std::function<double(const DeflectionLoop& loop, std::size_t sample)>;

/// Rows of residuals that a force makes which is added to the readings of some shots: in standard
/// deviations of the noise, and whitened as the residuals are.
Eigen::VectorXd whitened_rows(const Observations& seen, const HypothesisFit& fit,
                              const std::vector<DeflectionLoop>& loops,
                              const std::vector<std::size_t>& shots, const ForceOnLoop& force);

}  // namespace rebound
