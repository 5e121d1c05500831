#pragma once

#include <limits>

#include "lumped/problem/validity.hpp"

namespace rebound {

/// What a plate's load cell stands on: at the defaults a rigid floor, else a rigid body of mass M_f
/// on a spring and a damper of its own.
struct PlateFrame {
  double stiffness = std::numeric_limits<double>::infinity();  ///< k_f [N/m]
  double mass = 5.0;            ///< M_f [kg]; of no account while the stiffness is infinite
  double damping_ratio = 0.02;  ///< ζ_f [-]; of no account while the stiffness is infinite

  bool moves() const { return stiffness < std::numeric_limits<double>::infinity(); }

  static constexpr auto limits() {
    constexpr double rigid = std::numeric_limits<double>::infinity();
    return std::tuple{Limit{&PlateFrame::stiffness, "stiffness", "MN/m", above(0.0), rigid},
                      Limit{&PlateFrame::mass, "mass", "kg", from_to(1e-6, 1e6)},
                      Limit{&PlateFrame::damping_ratio, "damping_ratio", "", from_to(0.0, 10.0)}};
  }
  friend bool operator==(const PlateFrame&, const PlateFrame&) = default;
};

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
  PlateFrame frame{};           ///< of no account while the stiffness is infinite

  bool moves() const { return stiffness < std::numeric_limits<double>::infinity(); }

  static constexpr auto limits() {
    constexpr double rigid = std::numeric_limits<double>::infinity();
    return std::tuple{Limit{&Plate::stiffness, "stiffness", "MN/m", above(0.0), rigid},
                      Limit{&Plate::mass, "mass", "kg", from_to(1e-6, 1e6)},
                      Limit{&Plate::damping_ratio, "damping_ratio", "", from_to(0.0, 10.0)},
                      Limit{&Plate::friction, "friction", "", from_to(0.0, 5.0), 0.0}};
  }
  friend bool operator==(const Plate&, const Plate&) = default;
};

}  // namespace rebound
