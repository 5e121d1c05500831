#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Hunt–Crossley frozen at one representative deflection: a linear model.
///
///   F = k_eq x + c_eq ẋ,   k_eq = κ x_R^(n−1),   c_eq = λ x_R^n
///
///   κ     Hunt–Crossley stiffness    [N/mⁿ]
///   λ     Hunt–Crossley damping      [N s/m^(n+1)]
///   n     exponent, 1.5 for Hertz    [-]
///   x_R   representative deflection; the source uses the time mean over the contact [m]
///
/// Valid:   as the source's linear reading of Hunt–Crossley.
/// Limit:   n = 1, x_R = 1 m has the numbers of LinearKelvinVoigt
///          -> test EquivalentKelvinVoigtTest.ReducesToLinear.
/// Caution: as LinearKelvinVoigt; and x_R comes from a measurement or another
///          model, so this law predicts nothing by itself.
/// Source:  Hanley et al., Eqs (14)–(16) of the sliotar core paper.
struct EquivalentKelvinVoigt {
  double linear_stiffness = 0.0;           ///< k_eq [N/m]
  double linear_damping = 0.0;             ///< c_eq [N s/m]
  double exponent = 1.5;                   ///< n
  double representative_deflection = 1.0;  ///< x_R [m]

  static LawCard card();
  static EquivalentKelvinVoigt from(const ParameterValues& values);
  /// Formula "exact" only, for c_eq; returned as λ = c_eq / x_Rⁿ.
  static double damping_for(const DampingRequest& request);

  double elastic_force(double x) const { return linear_stiffness * x; }
  double damping_force(double, double v) const { return linear_damping * v; }
  double force(double x, double v) const { return linear_stiffness * x + linear_damping * v; }
  ForceSlopes at_root(double u, double v) const {
    const double elastic = linear_stiffness * u * std::abs(u);
    return {elastic + linear_damping * v, linear_damping * v, elastic, linear_damping};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    const double x = u * std::abs(u), elastic = linear_stiffness * x, lost = linear_damping * v;
    switch (parameter) {
      case 0: return std::log(representative_deflection) * (elastic + lost);
      case 1: return x * std::pow(representative_deflection, exponent - 1.0);
      case 2: return v * std::pow(representative_deflection, exponent);
      default: return ((exponent - 1.0) * elastic + exponent * lost) / representative_deflection;
    }
  }
  double elastic_energy(double x) const { return 0.5 * linear_stiffness * x * x; }
};

static_assert(ContactLaw<EquivalentKelvinVoigt>);

}  // namespace rebound
