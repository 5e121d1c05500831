#pragma once

#include "comparisons/evaluation/convert/conversion.hpp"

namespace rebound {

/// How a game or robot engine advances a spring and a dashpot of a contact over one step.
enum class ContactStepping {
  implicit,       ///< force of the end of the step: ERP and CFM of ODE and its kin
  predicted,      ///< the same, from the step on that would end in contact: Bullet
  semi_implicit,  ///< force of the beginning, position by the new speed: soft constraints of MuJoCo
};

/// A ball on a linear spring and dashpot that never pull, with the engine's own steps.
struct SteppedContact {
  double mass = 0.0;     ///< m [kg]
  double speed = 0.0;    ///< v [m/s]
  double spring = 0.0;   ///< k [N/m]
  double dashpot = 0.0;  ///< c [N s/m]
  double step = 0.0;     ///< h [s]
  double late = 0.0;     ///< share of a step by which the touch is found late, 0 to 1
  ContactStepping stepping = ContactStepping::implicit;
};

/// Restitution, contact time and largest force, as the engine finds them.
///
///   implicit        v₁ = (v₀ − h k x₀/m)/(1 + h c/m + h² k/m)
///   predicted       the same; where x₀ < 0 with (h k + c) in place of h k
///   semi-implicit   v₁ = v₀ − h (k x₀ + c v₀)/m
///   all             x₁ = x₀ + h v₁,   force m (v₀ − v₁)/h, no less than 0
///
/// The first step begins `late` · h after touch, at x₀ = late · h v: an engine looks for contacts
/// once a step. The energy of a spring that is first seen compressed was never paid, so that a late
/// contact bounces higher. A predicted one begins (1 − late) · h before touch.
/// Limit:  linear Kelvin-Voigt at zero force as h → 0, to first order
///         -> test SteppedContactTest.TendsToTheLawAtFirstOrder.
/// Errors: Error(solver_failed) where the ball is not back after a million steps.
Observed stepped_impact(const SteppedContact& contact);

}  // namespace rebound
