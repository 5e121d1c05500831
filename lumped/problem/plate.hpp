#pragma once

#include <limits>

namespace rebound {

/// What the ball hits. At the defaults rigid, at rest for good, frictionless.
///
/// A plate that gives way is a rigid body of mass M on a spring and a damper,
/// as a plate on a load cell is:
///
///   M ÿ + 2 ζ √(k M) ẏ + k y = F,   load cell reads k y + 2 ζ √(k M) ẏ
///
///   y   displacement of the plate, away from the ball positive [m]
///   F   contact force                                          [N]
struct Plate {
  double stiffness = std::numeric_limits<double>::infinity();  ///< k [N/m]
  double mass = 2.0;            ///< M [kg]; of no account while the stiffness is infinite
  double damping_ratio = 0.02;  ///< ζ [-]; of no account while the stiffness is infinite
  double friction = 0.0;        ///< Coulomb coefficient [-]

  bool moves() const { return stiffness < std::numeric_limits<double>::infinity(); }

  friend bool operator==(const Plate&, const Plate&) = default;
};

}  // namespace rebound
