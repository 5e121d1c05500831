#pragma once

#include <limits>

#include "lumped/problem/validity.hpp"

namespace rebound {

/// A sinusoid in the force channel.
///
///   A sin(2π f u + φ),   u time since first touch [s]
struct Hum {
  double amplitude = 0.0;  ///< A [N]
  double frequency = 1e3;  ///< f [Hz]; of no account without an amplitude
  double phase = 0.0;      ///< φ at first touch [rad]

  friend bool operator==(const Hum&, const Hum&) = default;
};

/// An oscillation that starts at an instant and dies away.
///
///   A e^(−(u − t₀)/τ) sin(2π f (u − t₀)),   u ≥ t₀,   u time since first touch [s]
struct Burst {
  double amplitude = 0.0;      ///< A [N]
  double frequency = 3e3;      ///< f [Hz]; of no account without an amplitude
  double decay_time = 0.5e-3;  ///< τ [s]
  double instant = 0.0;        ///< t₀ [s]

  friend bool operator==(const Burst&, const Burst&) = default;
};

/// How what happened differs from what is reported. At the defaults, not at all.
///
///   force       min[(1 + g) F + b + d u + hum + burst, L],  F filtered, late and drooping, then
///               behind a filter without delay where the record is of an SAE J211 class,
///               g gain error, b baseline, d drift, u time since first touch, L clipping level;
///               with its noise rounded to steps of the recorder
///   time        (1 + s) u + trigger shift,                  s error of the time base
///   deflection  x + ½ a t², where it is a double integral, a integration drift;
///               (1 + h) x + z, where it is measured, h gain error, z zero
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
  double deflection_gain = 0.0;    ///< h [-]
  double deflection_zero = 0.0;    ///< z [m]
  double contact_threshold = 0.0;  ///< of reported contact times [N]
  int platens = 0;                 ///< as believed in slow compressions: 1 or 2; 0: as it was
  double force_drift = 0.0;        ///< d [N/s]
  double droop = 0.0;              ///< 1/τ of a first-order high-pass [1/s]
  double lag = 0.0;                ///< τ of a first-order low-pass [s]
  double second_lag = 0.0;         ///< τ of another behind it [s]
  Hum hum;
  Burst burst;
  double time_base = 0.0;  ///< s [-]
  /// Of the record's software filter without delay, SAE J211; 0: none [Hz].
  double filter_class = 0.0;
  /// Time over which a reading is a mean where a contact ends within it, far below the sample
  /// spacing [s].
  double aperture = 0.0;
  double clipping_level = std::numeric_limits<double>::infinity();  ///< L [N]
  double rounding_step = 0.0;  ///< of the recorder, which rounds the noise, too; 0: none [N]
  /// Which shot of the data it serves, from 1; 0: none. Faults of one shot act where it is theirs.
  int shot = 0;

  /// Of the numbers by which a record may be distorted; the others are free.
  static constexpr auto limits() {
    constexpr double none = std::numeric_limits<double>::infinity();
    return std::tuple{
        Limit{&MeasurementChain::bandwidth, "bandwidth", "Hz", above(0.0), none},
        Limit{&MeasurementChain::force_drift, "force_drift", "N/s", any_number()},
        Limit{&MeasurementChain::droop, "droop", "1/s", at_least(0.0)},
        Limit{&MeasurementChain::lag, "lag", "s", at_least(0.0)},
        Limit{&MeasurementChain::second_lag, "second_lag", "s", at_least(0.0)},
        Limit{&MeasurementChain::time_base, "time_base", "", above(-1.0)},
        Limit{&MeasurementChain::clipping_level, "clipping_level", "N", above(0.0), none},
        Limit{&MeasurementChain::filter_class, "filter_class", "Hz", at_least(0.0)},
        Limit{&MeasurementChain::rounding_step, "rounding_step", "N", at_least(0.0)}};
  }
  friend bool operator==(const MeasurementChain&, const MeasurementChain&) = default;
};

}  // namespace rebound
