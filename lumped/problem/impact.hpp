#pragma once

#include <numbers>

#include "lumped/problem/names.hpp"
#include "lumped/problem/validity.hpp"

namespace rebound {

/// The ball. Both tiers treat it as the same body: same mass, same diameter.
struct Sphere {
  double mass = 0.0;      ///< [kg]
  double diameter = 0.0;  ///< [m]

  double radius() const { return 0.5 * diameter; }
  double volume() const { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }
  double density() const { return mass / volume(); }

  static constexpr auto limits() {
    return std::tuple{Limit{&Sphere::mass, "mass", "g", above(0.0)},
                      Limit{&Sphere::diameter, "diameter", "mm", above(0.0)}};
  }

  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// When a contact counts as ended. The rule changes contact time and
/// restitution (Kelvin–Voigt, ζ = 0.20: e = 0.572 or 0.527), so every result
/// names the rule it was made with.
enum class SeparationRule {
  zero_force,       ///< last instant after which the compressive force stays zero
  zero_deflection,  ///< the centre of mass is back where first touch left it
};
constexpr auto names_of(SeparationRule) {
  return names_list<SeparationRule>({{"zero-force", SeparationRule::zero_force},
                                     {"zero-deflection", SeparationRule::zero_deflection}});
}

/// Normal impact on a plate at rest, no spin.
struct Impact {
  double speed = 0.0;  ///< approach speed at first touch, > 0 [m/s]
  SeparationRule separation = SeparationRule::zero_force;

  static constexpr auto limits() {
    return std::tuple{Limit{&Impact::speed, "speed", "m/s", above_up_to(0.0, 1000.0)}};
  }

  friend bool operator==(const Impact&, const Impact&) = default;
};

}  // namespace rebound
