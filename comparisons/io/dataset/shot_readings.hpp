#pragma once

#include <optional>

#include "comparisons/io/laboratory/bounce.hpp"

namespace rebound {

struct MeasuredImpact;

/// A reading and one standard deviation of it; what is absent was not read.
struct Reading {
  std::optional<double> value;
  std::optional<double> uncertainty;
};

/// What was read in place of a speed or a restitution: light gates, a ruler, a clock.
struct ShotReadings {
  Reading rebound_speed;      ///< [m/s]
  Reading gate_distance;      ///< between two light gates [m]
  Reading gate_time;          ///< from one to the other, on the way in [s]
  Reading rebound_gate_time;  ///< on the way back [s]
  Reading drop_height;        ///< from rest to first touch [m]
  Reading rebound_height;     ///< [m]
  Reading flight_time;        ///< from the bounce before to this one [s]
  Reading next_flight_time;   ///< from this bounce to the next [s]
  /// Readings that the values are means of: their uncertainties, those of one reading, shrink.
  std::optional<double> repeats;

  bool any() const;
};

/// The readings by their keys, for files and tables.
struct ReadingQuantity {
  const char* key;
  const char* sentence;
  const char* unit;
  Reading ShotReadings::*member;
};
inline constexpr ReadingQuantity reading_quantities[] = {
    {"rebound_speed", "Speed after the impact.", "m/s", &ShotReadings::rebound_speed},
    {"gate_distance", "Distance between two light gates.", "mm", &ShotReadings::gate_distance},
    {"gate_time", "Time between the light gates on the way in.", "ms", &ShotReadings::gate_time},
    {"rebound_gate_time", "Time between the light gates on the way back.", "ms",
     &ShotReadings::rebound_gate_time},
    {"drop_height", "Height of a drop from rest, bottom of the ball to the plate.", "m",
     &ShotReadings::drop_height},
    {"rebound_height", "Height of the rebound, bottom of the ball to the plate.", "m",
     &ShotReadings::rebound_height},
    {"flight_time", "Time from the bounce before to this one.", "s", &ShotReadings::flight_time},
    {"next_flight_time", "Time from this bounce to the next.", "s",
     &ShotReadings::next_flight_time},
};

/// Sets speed and restitution of a shot, with their uncertainties, from what was read.
///
///   approach   speed as stated; or gate_distance/gate_time; or a fall from drop_height; or the
///              landing after flight_time
///   rebound    rebound_speed; or gate_distance/rebound_gate_time; or a rise to rebound_height; or
///              next_flight_time
///   e = rebound/approach,   σ² = Σ (∂/∂reading · σ_reading)² / repeats, readings independent
///
/// What is stated stays; readings beside it are compared and must agree within three standard
/// deviations of both, and never less than a thousandth.
/// Caution: readings of one scale (gate distance, ruler) share its error, which then cancels in e
///          for the gates and does not for heights.
/// Errors:  Error(bad_input) with the key for a rebound without an approach, no speed at all, a
///          restitution above 1, and contradicting statements.
void settle_readings(MeasuredImpact& shot, const FreeFall& fall);

/// How much the restitution from heights or flight times changes when the air is taken into
/// account; 0 for readings that do not fall.
double change_by_air(const MeasuredImpact& shot, const Sphere& ball, const Air& air);

}  // namespace rebound
