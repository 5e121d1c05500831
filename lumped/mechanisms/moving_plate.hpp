#pragma once

#include <cmath>

#include "lumped/problem/plate.hpp"

/// A plate on a load cell: rigid mass M, spring k, damper c = 2 ζ √(k M); and, where the cell
/// stands on a frame that gives way too, the same of the frame.
///
///   M ÿ = F − C,   C = k (y − z) + c (ẏ − ż),   M_f z̈ = C − k_f z − c_f ż
///
///   y   displacement of the plate, away from the ball [m]      F   contact force [N]
///   z   that of the frame; 0 where it is rigid        [m]      C   what the load cell reads [N]
///
/// The law sees the ball's deflection less y.
/// Limit:   k → ∞ is a rigid plate; k → 0 an impact of two bodies with the
///          reduced mass m M/(m + M)
///          -> tests MovingPlateTest.StiffPlateIsRigid, FreePlateIsTwoBodies;
///          k_f → ∞ is a plate on its cell alone, M_f → 0 two springs in series
///          -> tests PlateFrameTest.AStiffFrameIsNone, ALightFrameIsASpringInSeries.
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

inline double frame_damping(const PlateFrame& frame) {
  return 2.0 * frame.damping_ratio * std::sqrt(frame.stiffness * frame.mass);
}

inline double load_cell_force(const Plate& plate, const PlateMotion& at, const PlateMotion& frame) {
  return plate.stiffness * (at.displacement - frame.displacement) +
         plate_damping(plate) * (at.velocity - frame.velocity);
}

inline double plate_acceleration(const Plate& plate, const PlateMotion& at,
                                 const PlateMotion& frame, double contact_force) {
  return (contact_force - load_cell_force(plate, at, frame)) / plate.mass;
}

inline double frame_acceleration(const Plate& plate, const PlateMotion& at,
                                 const PlateMotion& frame) {
  return (load_cell_force(plate, at, frame) - plate.frame.stiffness * frame.displacement -
          frame_damping(plate.frame) * frame.velocity) /
         plate.frame.mass;
}

/// Kinetic and spring energy [J].
inline double plate_energy(const Plate& plate, const PlateMotion& at, const PlateMotion& frame) {
  const double extension = at.displacement - frame.displacement;
  double energy =
      0.5 * plate.mass * at.velocity * at.velocity + 0.5 * plate.stiffness * extension * extension;
  if (plate.frame.moves())
    energy += 0.5 * plate.frame.mass * frame.velocity * frame.velocity +
              0.5 * plate.frame.stiffness * frame.displacement * frame.displacement;
  return energy;
}

/// No displacement of the plate is larger with this energy [m].
inline double plate_reach(const Plate& plate, double energy) {
  double reach = std::sqrt(2.0 * energy / plate.stiffness);
  if (plate.frame.moves()) reach += std::sqrt(2.0 * energy / plate.frame.stiffness);
  return reach;
}

}  // namespace rebound
