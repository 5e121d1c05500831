#pragma once

#include <limits>

namespace rebound {

/// How what happened differs from what is reported. At the defaults, not at all.
///
///   force       (1 + g) F filtered + b,     g gain error, b baseline
///   time        t + trigger shift
///   deflection  x + ½ a t², where it is a double integral, a integration drift
///   mass, speed reported = (1 + error) true
struct MeasurementChain {
  double force_gain = 0.0;      ///< g [-]
  double force_baseline = 0.0;  ///< b [N]
  double mass_error = 0.0;      ///< [-]
  double speed_error = 0.0;     ///< [-]
  double trigger_shift = 0.0;   ///< [s]
  /// Causal 4-pole Butterworth, −3 dB here [Hz].
  double bandwidth = std::numeric_limits<double>::infinity();
  double integration_drift = 0.0;  ///< a [m/s²]
  double contact_threshold = 0.0;  ///< of reported contact times [N]
  int platens = 0;                 ///< as believed in slow compressions: 1 or 2; 0: as it was

  friend bool operator==(const MeasurementChain&, const MeasurementChain&) = default;
};

}  // namespace rebound
