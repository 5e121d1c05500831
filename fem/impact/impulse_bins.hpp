#pragma once

#include <cstddef>
#include <vector>

namespace rebound::fem {

/// Impulse collected in half bins of an even time grid t_k = k Δ, and the
/// force that it means at the samples.
///
///   F_k = impulse delivered in [t_k − Δ/2, t_k + Δ/2] / (length of it)
///
/// so that the trapezoidal integral of the force is exactly the impulse,
/// whatever Δ -> test ImpactRecorderTest.TrapezoidGivesTheImpulse….
class ImpulseBins {
 public:
  ImpulseBins(double interval, std::size_t expected_samples);

  /// Impulse delivered evenly from `start` to `end`; what was before zero
  /// counts from zero.
  void add(double impulse, double start, double end);

  /// Force at the first `samples` grid points; the last is the mean of half a bin.
  std::vector<double> force(std::size_t samples) const;

  /// Mean forces over `half_bins` half bins each, slid by one; the first begins at zero.
  /// Two of no force stand behind the last impulse.
  std::vector<double> running_means(std::size_t half_bins) const;
  /// Grid points up to one behind the last impulse, for force().
  std::size_t filled() const { return half_bins_.size() / 2 + 3; }

  double interval() const { return interval_; }
  double total() const { return total_; }

 private:
  double interval_;
  double total_ = 0.0;
  std::vector<double> half_bins_;  ///< impulse in [k Δ/2, (k+1) Δ/2]
};

}  // namespace rebound::fem
