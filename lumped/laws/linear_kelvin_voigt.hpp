#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Linear Kelvin–Voigt contact.
///
///   F = κ x + λ ẋ
///
///   κ   stiffness     [N/m]
///   λ   damping       [N s/m]
///
/// Valid:   as a comparison model only; a sphere's contact stiffens with x.
/// Limit:   λ = 0 conserves energy -> test LawBattery.ElasticLimitConservesEnergy.
/// Caution: the force jumps to λ v₀ at first touch, and pulls before x = 0 on
///          rebound: the separation rule decides e (ζ = 0.20: 0.572 at zero
///          force, 0.527 at zero deflection). Overdamped it never comes back
///          to x = 0.
/// Source:  Hanley et al., Eqs (4), (11)–(13) of the sliotar core paper.
struct LinearKelvinVoigt {
  double stiffness = 0.0;
  double damping = 0.0;

  static LawCard card();
  static LinearKelvinVoigt from(const ParameterValues& values);
  /// Formula "exact" only: inverts e(ζ) under the separation rule of the impact.
  static double damping_for(const DampingRequest& request);

  double elastic_force(double x) const { return stiffness * x; }
  double damping_force(double, double v) const { return damping * v; }
  double force(double x, double v) const { return stiffness * x + damping * v; }
  ForceSlopes at_root(double u, double v) const {
    const double elastic = stiffness * u * std::abs(u);
    return {elastic + damping * v, damping * v, elastic, damping};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    return parameter == 0 ? u * std::abs(u) : v;
  }
  double elastic_energy(double x) const { return 0.5 * stiffness * x * x; }
};

static_assert(ContactLaw<LinearKelvinVoigt>);

}  // namespace rebound
