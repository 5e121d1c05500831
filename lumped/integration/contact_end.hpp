#pragma once

#include "lumped/problem/impact.hpp"

namespace rebound {

/// What an integrator needs to know of an impact beside the law.
struct ContactSetup {
  double mass = 0.0;   ///< [kg]
  double speed = 0.0;  ///< approach speed [m/s]
  SeparationRule separation = SeparationRule::zero_force;
  double relative_tolerance = 1e-9;
  int most_steps = 50'000;  ///< of a composed contact, by the fast integrator
};

/// State at separation, and the two integrals taken along the way.
struct ContactEnd {
  double time = 0.0;        ///< contact time [s]
  double deflection = 0.0;  ///< zero under the zero-deflection rule [m]
  double velocity = 0.0;    ///< closing positive, so negative here [m/s]
  double impulse = 0.0;     ///< ∫ F dt [N s]
  double dissipated = 0.0;  ///< ∫ F_d ẋ dt [J]
};

}  // namespace rebound
