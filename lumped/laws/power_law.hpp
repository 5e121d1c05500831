#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"
#include "lumped/laws/power.hpp"

namespace rebound {

/// The general power law the others are cases of.
///
///   F = κ x^{n₂} x + λ x^{n₁} ẋ
///
///   κ    stiffness            [N/m^(n₂+1)]
///   λ    damping              [N s/m^(n₁+1)]
///   n₁   damping exponent     [-]
///   n₂   stiffness exponent, one less than the power of the elastic force [-]
///
/// Valid:   n₁ ≥ 0, n₂ > −½ (a finite contact time).
/// Limit:   n₁ = n₂ = 0 linear Kelvin–Voigt, n₁ = n₂ = ½ Hertz damped,
///          n₁ = n₂ + 1 Hunt–Crossley -> test PowerLawTest.ContainsTheOthers.
/// Caution: for n₁ < n₂ + 1 the force pulls before x = 0 on rebound.
/// Source:  Hanley et al., Eq. (3) of the sliotar core paper.
struct PowerLaw {
  double stiffness = 0.0;
  double damping = 0.0;
  Power elastic_power{1.0};  ///< n₂ + 1
  Power damping_power{0.0};  ///< n₁

  static LawCard card();
  static PowerLaw from(const ParameterValues& values);

  double elastic_force(double x) const {
    return std::copysign(stiffness * elastic_power(std::abs(x)), x);
  }
  double damping_force(double x, double v) const {
    return damping * damping_power(std::abs(x)) * v;
  }
  double force(double x, double v) const { return elastic_force(x) + damping_force(x, v); }
  ForceSlopes at_root(double u, double v) const {
    const double size = std::abs(u), slope = damping * damping_power.of_root(size);
    const double elastic = std::copysign(stiffness * elastic_power.of_root(size), u);
    const double lost = slope * v;
    return {elastic + lost, lost,
            elastic_power.exponent() * elastic + damping_power.exponent() * lost, slope};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    const double size = std::abs(u);
    switch (parameter) {
      case 0: return damping * damping_power.of_root(size) * v * log_of_root(u);
      case 1: return std::copysign(stiffness * elastic_power.of_root(size), u) * log_of_root(u);
      case 2: return std::copysign(elastic_power.of_root(size), u);
      default: return damping_power.of_root(size) * v;
    }
  }
  double elastic_energy(double x) const {
    return elastic_force(x) * x / (elastic_power.exponent() + 1.0);
  }
};

static_assert(ContactLaw<PowerLaw>);

}  // namespace rebound
