#pragma once

#include <vector>

namespace rebound::fem {

/// Passes over all values of the nodes, [node][2] (r, z), with the instructions of this machine.
/// Sums run in eight strands, in the same order on each instruction set and without FMA, so that
/// every bit is the same -> test NodePassesTest.SumsAreThoseOneByOne.

/// a ← a + s b.
void add_scaled(std::vector<double>& a, double s, const std::vector<double>& b);

struct WeightedSums {
  double squares = 0.0;  ///< Σ m (b_r² + b_z²)
  double axial = 0.0;    ///< Σ m b_z
};
/// `weight` has each node's twice, as [node][2]; both are as long.
WeightedSums weighted_sums(const std::vector<double>& weight, const std::vector<double>& b);

}  // namespace rebound::fem
