#pragma once

#include "lumped/problem/impact.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// The scalars every tier reports, by one definition (see scalars.hpp).
struct ImpactScalars {
  double restitution = 0.0;        ///< rebound speed over approach speed [-]
  double contact_time = 0.0;       ///< by the separation rule [s]
  double contact_time_1pct = 0.0;  ///< between first and last crossing of 1 % of peak force [s]
  double peak_force = 0.0;         ///< [N]
  double peak_deflection = 0.0;    ///< [m]
  double mean_deflection = 0.0;    ///< time mean over the contact [m]
  double rebound_speed = 0.0;      ///< [m/s]
  SeparationRule separation = SeparationRule::zero_force;
};

/// Share of the kinetic energy that the impact took, 1 − e² [-].
inline double kinetic_energy_loss_share(const ImpactScalars& scalars) {
  return 1.0 - scalars.restitution * scalars.restitution;
}

/// How well momentum and energy balance; part of every result.
struct Closures {
  /// |∫F dt − m (v₀ + v₁ + g T)| / (m (v₀ + v₁ + g T)), F the contact force, v₁ the
  /// speed at T found without using F.
  double impulse = 0.0;
  /// |energy found − energy brought| / (½ m v₀²), all channels counted.
  double energy = 0.0;
};

/// Result of one lumped impact.
struct LumpedResult {
  Trace trace;
  ImpactScalars scalars;
  Closures closures;
  double wall_seconds = 0.0;  ///< integration alone
};

}  // namespace rebound
