#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Viscoelastic sphere on a rigid plate, by its dissipation time.
///
///   F = κ x^{3/2} + (3/2) A κ x^{1/2} ẋ,    κ = (4/3) E* √R
///
///   κ   stiffness          [N/m^1.5]
///   A   dissipation time   [s]
///
/// A belongs to the material alone: τ of a Kelvin–Voigt solid whose shear and
/// bulk viscosity share it, tan δ/ω of any solid at frequency ω. HertzDamped
/// is the same force with λ = (3/2) A κ; here one A serves every size and
/// stiffness of ball.
///
/// Valid:   x ≪ R, A ≪ contact time, contact slow against wave transit.
/// Limit:   A = 0 is Hertz; the force of HertzDamped
///          -> test KuwabaraKonoTest.IsHertzDampedByAnotherName; e at zero force
///          -> test KuwabaraKonoTest.ZeroForceFollowsThePadeForm.
/// Caution: the force pulls before x = 0 on rebound: the separation rule
///          decides e.
/// Source:  Kuwabara & Kono 1987; Brilliantov et al. 1996.
struct KuwabaraKono {
  double stiffness = 0.0;
  double dissipation_time = 0.0;

  static LawCard card();
  static KuwabaraKono from(const ParameterValues& values);

  double elastic_force(double x) const { return stiffness * x * std::sqrt(std::abs(x)); }
  double damping_force(double x, double v) const {
    return 1.5 * dissipation_time * stiffness * std::sqrt(std::abs(x)) * v;
  }
  double force(double x, double v) const {
    return stiffness * std::sqrt(std::abs(x)) * (x + 1.5 * dissipation_time * v);
  }
  ForceSlopes at_root(double u, double v) const {
    const double elastic = stiffness * u * u * u;
    const double slope = 1.5 * dissipation_time * stiffness * std::abs(u), lost = slope * v;
    return {elastic + lost, lost, 1.5 * elastic + 0.5 * lost, slope};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    if (parameter == 0) return u * u * u + 1.5 * dissipation_time * std::abs(u) * v;
    return 1.5 * stiffness * std::abs(u) * v;
  }
  double elastic_energy(double x) const { return 0.4 * stiffness * x * x * std::sqrt(std::abs(x)); }
};

static_assert(ContactLaw<KuwabaraKono>);

}  // namespace rebound
