#pragma once

#include <cmath>

#include "lumped/problem/plate.hpp"

/// A plate on a load cell: rigid mass M, spring k, damper c = 2 ζ √(k M).
///
///   M ÿ + c ẏ + k y = F,   the load cell reads k y + c ẏ
///
///   y   displacement away from the ball [m]      F   contact force [N]
///
/// The law sees the ball's deflection less y.
/// Limit:   k → ∞ is a rigid plate; k → 0 an impact of two bodies with the
///          reduced mass m M/(m + M)
///          -> tests MovingPlateTest.StiffPlateIsRigid, FreePlateIsTwoBodies.
/// Caution: a plate still rings when the ball has left; a light one may strike
///          it again.
namespace rebound {

/// Displacement and velocity of the plate.
struct PlateMotion {
  double displacement = 0.0;  ///< [m]
  double velocity = 0.0;      ///< [m/s]
};

inline double plate_damping(const Plate& plate) {
  return 2.0 * plate.damping_ratio * std::sqrt(plate.stiffness * plate.mass);
}

inline double load_cell_force(const Plate& plate, const PlateMotion& at) {
  return plate.stiffness * at.displacement + plate_damping(plate) * at.velocity;
}

inline double plate_acceleration(const Plate& plate, const PlateMotion& at, double contact_force) {
  return (contact_force - load_cell_force(plate, at)) / plate.mass;
}

/// Kinetic and spring energy [J].
inline double plate_energy(const Plate& plate, const PlateMotion& at) {
  return 0.5 * plate.mass * at.velocity * at.velocity +
         0.5 * plate.stiffness * at.displacement * at.displacement;
}

}  // namespace rebound
