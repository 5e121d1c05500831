#pragma once

#include <vector>

#include "fem/impact/impulse_bins.hpp"
#include "fem/interface/fem_result.hpp"

namespace rebound::fem {

/// Which force the instrument reads.
enum class Reading { contact_force, load_cell };

/// Collects the force history of an explicit run on an even time grid; forces
/// are impulses per bin (see ImpulseBins).
///
/// With a load cell its reading is the trace's force, and the columns
/// contact_force_N and plate_displacement_m stand beside it.
class ImpactRecorder {
 public:
  ImpactRecorder(double interval, double expected_duration,
                 Reading reading = Reading::contact_force);

  /// Impulse on the body, delivered evenly from `start` to `end`.
  void add_impulse(double impulse, double start, double end) {
    contact_.add(impulse, start, end);
    half_windows_.add(impulse, start, end);
  }
  /// Impulse on the load cell.
  void add_reading(double impulse, double start, double end) { cell_.add(impulse, start, end); }

  /// Instant of the next sample not yet recorded.
  double next_sample() const { return interval_ * static_cast<double>(time_.size()); }

  struct Sample {
    double deflection;
    double pole_deflection;
    double contact_radius;
    double plate_displacement;
  };
  void add_sample(const Sample& sample, const EnergyBalance& energies);

  /// The trace up to the last sample; its last force is the mean of half a bin.
  Trace trace() const;
  /// Mean contact force at the samples; its trapezoidal integral is the impulse on the body.
  std::vector<double> contact_force() const { return contact_.force(time_.size()); }
  const std::vector<EnergyBalance>& energies() const { return energies_; }
  double total_impulse() const { return contact_.total(); }
  /// The same force in bins of half an averaging window (window_scalars).
  const ImpulseBins& half_windows() const { return half_windows_; }

 private:
  double interval_;
  Reading reading_;
  ImpulseBins contact_, cell_, half_windows_;
  std::vector<double> time_, deflection_, pole_deflection_, contact_radius_, plate_displacement_;
  std::vector<EnergyBalance> energies_;
};

}  // namespace rebound::fem
