#pragma once

#include "lumped/laws/laws.hpp"

namespace rebound {

/// The ordinary differential equations of one impact, in time.
///
///   ẋ = v,   v̇ = −F(x, v)/m,   J̇ = F,   Ḋ = F_d v
///
///   x   deflection [m]     v   closing speed [m/s]    m   mass [kg]
///   J   impulse [N s]      D   dissipated energy [J]
///
/// States of further mechanisms follow after `dissipated`: add them to the
/// enumeration, their rates to derivative(), their force to the total.
struct ContactSystem {
  enum State { deflection, velocity, impulse, dissipated, states };

  AnyLaw law;
  double mass = 0.0;

  double force(const double* y) const;
  void derivative(const double* y, double* rate) const;
};

}  // namespace rebound
