#pragma once

#include <vector>

#include "lumped/problem/result.hpp"

namespace rebound::fem {

/// Collects the force history of an explicit run on an even time grid
/// t_k = k Δ.
///
///   F_k = impulse delivered in [t_k − Δ/2, t_k + Δ/2] / (length of it)
///
/// so that the trapezoidal integral of the recorded force is exactly the
/// impulse, whatever Δ. The impulse of a step is spread evenly over its span.
class ImpactRecorder {
 public:
  ImpactRecorder(double interval, double expected_duration);

  /// Impulse delivered evenly from `start` to `end`.
  void add_impulse(double impulse, double start, double end);

  /// Instant of the next sample not yet recorded.
  double next_sample() const { return interval_ * static_cast<double>(time_.size()); }

  struct Sample {
    double deflection;
    double pole_deflection;
    double contact_radius;
  };
  void add_sample(const Sample& sample, const EnergyBook& energies);

  /// The trace up to the last sample; its last force is the mean of half a bin.
  Trace trace() const;
  const std::vector<EnergyBook>& energies() const { return energies_; }
  double total_impulse() const { return total_impulse_; }

 private:
  double interval_;
  double total_impulse_ = 0.0;
  std::vector<double> half_bins_;  ///< impulse in [k Δ/2, (k+1) Δ/2]
  std::vector<double> time_, deflection_, pole_deflection_, contact_radius_;
  std::vector<EnergyBook> energies_;
};

}  // namespace rebound::fem
