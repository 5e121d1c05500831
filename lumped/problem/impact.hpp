#pragma once

#include <numbers>

namespace rebound {

/// The ball. Both tiers treat it as the same body: same mass, same diameter.
struct Sphere {
  double mass = 0.0;      ///< [kg]
  double diameter = 0.0;  ///< [m]

  double radius() const { return 0.5 * diameter; }
  double volume() const { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }
  double density() const { return mass / volume(); }

  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// When a contact counts as ended. The rule changes contact time and
/// restitution (Kelvin–Voigt, ζ = 0.20: e = 0.572 or 0.527), so every result
/// names the rule it was made with.
enum class SeparationRule {
  zero_force,       ///< last instant after which the compressive force stays zero
  zero_deflection,  ///< the centre of mass is back where first touch left it
};

/// Normal impact on a plate at rest, no spin.
struct Impact {
  double speed = 0.0;  ///< approach speed at first touch, > 0 [m/s]
  SeparationRule separation = SeparationRule::zero_force;

  friend bool operator==(const Impact&, const Impact&) = default;
};

}  // namespace rebound
