#pragma once

#include <numbers>

#include "lumped/problem/mechanisms.hpp"

/// A ball of two masses: (1 − s) m touches the plate, s m hangs on it by a
/// spring and a damper.
///
///   r̈ + 2 ζ ω ṙ + ω² r = F/((1 − s) m),   ω = 2π f
///
///   r   displacement of the inner mass towards the plate, relative to the
///       outer one [m];   s   mass fraction [-];   f   of the free ball [Hz]
///   F   contact force [N]
///
/// x, the centre of mass, moves as m ẍ = −F; the law sees x − s r, the
/// deflection of the part in contact.
/// Valid:   0 ≤ s < 1.
/// Limit:   f → ∞ is a rigid ball -> test InternalModeTest.HighFrequencyIsOneMass.
/// Caution: one mode stands for the sphere's many; f and s are not those of a
///          normal mode of the sphere.
namespace rebound {

struct ModeMotion {
  double displacement = 0.0;  ///< r [m]
  double velocity = 0.0;      ///< ṙ [m/s]
};

inline double mode_angular_frequency(const InternalMode& mode) {
  return 2.0 * std::numbers::pi * mode.frequency;
}

/// Mass of the relative motion, s (1 − s) m [kg].
inline double mode_mass(const InternalMode& mode, double mass) {
  return mode.mass_fraction * (1.0 - mode.mass_fraction) * mass;
}

inline double mode_acceleration(const InternalMode& mode, const ModeMotion& at,
                                double driving_acceleration) {
  const double omega = mode_angular_frequency(mode);
  return driving_acceleration -
         omega * (2.0 * mode.damping_ratio * at.velocity + omega * at.displacement);
}

/// Power lost in the inner damper [W].
inline double mode_loss(const InternalMode& mode, const ModeMotion& at, double mass) {
  return 2.0 * mode.damping_ratio * mode_angular_frequency(mode) * mode_mass(mode, mass) *
         at.velocity * at.velocity;
}

/// Kinetic energy about the centre of mass and energy of the inner spring [J].
inline double mode_energy(const InternalMode& mode, const ModeMotion& at, double mass) {
  const double omega = mode_angular_frequency(mode);
  return 0.5 * mode_mass(mode, mass) *
         (at.velocity * at.velocity + omega * omega * at.displacement * at.displacement);
}

}  // namespace rebound
