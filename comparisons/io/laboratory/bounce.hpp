#pragma once

#include "lumped/problem/impact.hpp"

namespace rebound {

/// Standard acceleration of free fall [m/s²].
inline constexpr double free_fall_acceleration = 9.80665;

/// The air that a ball falls through.
struct Air {
  double density = 1.204;         ///< 20 °C, 101.325 kPa [kg/m³]
  double drag_coefficient = 0.5;  ///< of the ball [-]
};

/// Free fall of a ball through air at rest, straight down and up.
///
///   m v̇ = m g − ½ ρ c_d (π d²/4) v|v|,     w² = m g / (½ ρ c_d π d²/4)
///   down from rest by h     v² = w² (1 − exp(−2 g h/w²))
///   up to h                 v² = w² (exp(2 g h/w²) − 1)
///
///   w  speed at which drag is the weight [m/s];  without air w = ∞: v² = 2 g h
///
/// Valid:   c_d constant (a smooth ball: Reynolds numbers of 1e3 to 2e5; seams and fuzz change it);
///          buoyancy and spin left out.
/// Limit:   a thin air gives the closed forms without -> test BounceTest.ThinAirIsNone; the motion
///          integrated numerically -> test BounceTest.FallIsThatOfTheEquationOfMotion.
/// Source:  momentum balance; the closed forms are textbook.
class FreeFall {
 public:
  FreeFall() = default;  ///< without air
  FreeFall(const Sphere& ball, const Air& air);

  /// Speed after a fall from rest by `height` [m].
  double landing_speed(double height) const;
  /// Speed with which a ball must leave to rise by `height` [m].
  double launch_speed(double height) const;
  /// Height reached by a ball that leaves with `speed`.
  double height_reached(double speed) const;
  /// From leaving to landing [s], for a ball that leaves with `speed`.
  double flight_time(double speed) const;
  /// Speed with which a ball must leave to land after `time` [s].
  double launch_speed_for(double time) const;

 private:
  double rate_ = 0.0;  ///< 1/w² [s²/m²]; 0: no air
};

}  // namespace rebound
