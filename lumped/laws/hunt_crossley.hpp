#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"
#include "lumped/laws/power.hpp"

namespace rebound {

/// Hunt–Crossley contact.
///
///   F = xⁿ (κ + λ ẋ)
///
///   κ   stiffness                 [N/mⁿ]
///   λ   damping                   [N s/m^(n+1)]
///   n   exponent, 1.5 for Hertz   [-]
///
/// Valid:   e depends on p = λ v₀/κ alone, whatever n and the mass.
/// Limit:   λ = 0 is Hertz's impact -> test ClosedFormsTest.HuntCrossleyWithoutLossIsHertz.
/// Caution: with constant λ, 1 − e grows in proportion to the speed; the
///          source therefore fitted λ speed by speed. Force and deflection
///          reach zero together: both separation rules agree.
/// Source:  Hunt & Crossley 1975; Hanley et al., Eqs (6)–(9).
struct HuntCrossley {
  double stiffness = 0.0;
  double damping = 0.0;
  Power power{1.5};

  static LawCard card();
  static HuntCrossley from(const ParameterValues& values);
  /// Every name of damping_formulas.hpp.
  static double damping_for(const DampingRequest& request);

  double elastic_force(double x) const { return std::copysign(stiffness * power(std::abs(x)), x); }
  double damping_force(double x, double v) const { return damping * power(std::abs(x)) * v; }
  double force(double x, double v) const {
    const double xn = power(std::abs(x));
    return std::copysign(stiffness * xn, x) + damping * xn * v;
  }
  ForceSlopes at_root(double u, double v) const {
    return with_power(power.of_root(std::abs(u)), u, v);
  }
  /// The law once its power is known to be Hertz's: nothing is left to choose in a loop.
  struct Hertz;
  ForceSlopes with_power(double xn, double u, double v) const {
    const double elastic = std::copysign(stiffness * xn, u), lost = damping * xn * v;
    return {elastic + lost, lost, power.exponent() * (elastic + lost), damping * xn};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    const double xn = power.of_root(std::abs(u));
    switch (parameter) {
      case 0: return (std::copysign(stiffness * xn, u) + damping * xn * v) * log_of_root(u);
      case 1: return std::copysign(xn, u);
      default: return xn * v;
    }
  }
  double elastic_energy(double x) const {
    return stiffness * std::abs(x) * power(std::abs(x)) / (power.exponent() + 1.0);
  }
};

struct HuntCrossley::Hertz {
  HuntCrossley law;

  ForceSlopes at_root(double u, double v) const {
    return law.with_power(std::abs(u * u * u), u, v);
  }
};

static_assert(ContactLaw<HuntCrossley>);

}  // namespace rebound
