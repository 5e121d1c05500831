#include "comparisons/io/dataset/shot_readings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Speed = std::optional<double>;

Speed approach_of(const ShotReadings& read, const FreeFall& fall) {
  if (read.gate_distance.value && read.gate_time.value)
    return *read.gate_distance.value / *read.gate_time.value;
  if (read.drop_height.value) return fall.landing_speed(*read.drop_height.value);
  if (read.flight_time.value) {
    const double launch = fall.launch_speed_for(*read.flight_time.value);
    return fall.landing_speed(fall.height_reached(launch));
  }
  return std::nullopt;
}

Speed rebound_of(const ShotReadings& read, const FreeFall& fall) {
  if (read.rebound_speed.value) return read.rebound_speed.value;
  if (read.gate_distance.value && read.rebound_gate_time.value)
    return *read.gate_distance.value / *read.rebound_gate_time.value;
  if (read.rebound_height.value) return fall.launch_speed(*read.rebound_height.value);
  if (read.next_flight_time.value) return fall.launch_speed_for(*read.next_flight_time.value);
  return std::nullopt;
}

/// A number that follows from readings, with its standard deviation by central differences. A
/// reading that cancels, as the distance of gates does in a restitution, leaves rounding alone:
/// that is no uncertainty, and would weigh without bound in a fit.
Measured derived_from(const ShotReadings& read,
                      const std::function<Speed(const ShotReadings&)>& number) {
  Measured result;
  result.value = number(read);
  if (!result.value) return result;
  double variance = 0.0;
  for (const ReadingQuantity& quantity : reading_quantities) {
    const Reading& one = read.*quantity.member;
    if (!one.value || !one.uncertainty) continue;
    constexpr double share = 1e-3;  // of a standard deviation: errors of second order vanish
    ShotReadings above = read, below = read;
    (above.*quantity.member).value = *one.value + share * *one.uncertainty;
    (below.*quantity.member).value = *one.value - share * *one.uncertainty;
    const double change = (*number(above) - *number(below)) / (2.0 * share);
    constexpr double rounding = 1e-11;
    if (std::abs(change) > rounding * std::abs(*result.value)) variance += change * change;
  }
  if (variance > 0.0) result.uncertainty = std::sqrt(variance / read.repeats.value_or(1.0));
  return result;
}

void need_agreement(const char* key, double stated, const std::optional<double>& stated_error,
                    const Measured& read) {
  constexpr double deviations = 3.0, least_share = 1e-3;
  const double error = std::hypot(stated_error.value_or(0.0), read.uncertainty.value_or(0.0));
  if (std::abs(stated - *read.value) <= std::fmax(deviations * error, least_share * stated)) return;
  throw Error(ExitCode::bad_input,
              fmt::format("what is stated contradicts the readings beside it, which give {:.5g}",
                          *read.value),
              {.key = key, .value = fmt::format("{:.6g}", stated)});
}

void settle_speed(MeasuredImpact& shot, const FreeFall& fall) {
  const Measured approach = derived_from(
      shot.readings, [&](const ShotReadings& read) { return approach_of(read, fall); });
  double& speed = shot.impact.speed;
  if (speed > 0.0) {
    if (approach.value) need_agreement("speed", speed, shot.speed_uncertainty, approach);
    return;
  }
  if (!approach.value)
    throw Error(ExitCode::bad_input,
                "the shot states no speed: speed, gate_distance and gate_time, drop_height or "
                "flight_time is needed",
                {.key = "speed"});
  speed = *approach.value;
  if (!shot.speed_uncertainty) shot.speed_uncertainty = approach.uncertainty;
}

void settle_restitution(MeasuredImpact& shot, const FreeFall& fall) {
  const double stated_speed = shot.impact.speed;
  const bool from_readings = approach_of(shot.readings, fall).has_value();
  Measured found = derived_from(shot.readings, [&](const ShotReadings& read) -> Speed {
    const Speed rebound = rebound_of(read, fall);
    if (!rebound) return std::nullopt;
    return *rebound / approach_of(read, fall).value_or(stated_speed);
  });
  if (!found.value) return;
  if (!from_readings && shot.speed_uncertainty)
    found.uncertainty = std::hypot(found.uncertainty.value_or(0.0),
                                   *found.value * *shot.speed_uncertainty / stated_speed);
  if (shot.restitution.value) {
    need_agreement("restitution", *shot.restitution.value, shot.restitution.uncertainty, found);
    return;
  }
  if (!(*found.value <= 1.0))
    throw Error(ExitCode::bad_input,
                "the ball leaves faster than it came: are approach and rebound exchanged, or a "
                "unit wrong?",
                {.key = "restitution",
                 .value = fmt::format("{:.5g}", *found.value),
                 .allowed = "0 <= value <= 1"});
  const auto stated_error = shot.restitution.uncertainty;
  shot.restitution = found;
  if (stated_error) shot.restitution.uncertainty = stated_error;
}

}  // namespace

bool ShotReadings::any() const {
  for (const ReadingQuantity& quantity : reading_quantities)
    if ((this->*quantity.member).value) return true;
  return false;
}

void settle_readings(MeasuredImpact& shot, const FreeFall& fall) {
  settle_speed(shot, fall);
  settle_restitution(shot, fall);
}

double change_by_air(const MeasuredImpact& shot, const Sphere& ball, const Air& air) {
  const ShotReadings& read = shot.readings;
  const bool falls = read.rebound_height.value || read.next_flight_time.value;
  const auto restitution = [&](const FreeFall& fall) {
    const Speed approach = approach_of(read, fall), rebound = rebound_of(read, fall);
    return approach && rebound ? *rebound / *approach : 0.0;
  };
  return falls ? restitution(FreeFall(ball, air)) - restitution(FreeFall()) : 0.0;
}

}  // namespace rebound
