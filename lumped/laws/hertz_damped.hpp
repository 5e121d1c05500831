#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Hertz contact with damping in proportion to the contact radius
/// (Kuwabara–Kono): what continuum theory gives for a viscoelastic sphere.
///
///   F = κ x^{3/2} + λ x^{1/2} ẋ,    λ = (3/2) A κ
///
///   κ   stiffness, (4/3) E* √R on a rigid plate   [N/m^1.5]
///   λ   damping                                   [N s/m^1.5]
///   A   dissipation time                          [s]
///
/// Valid:   x ≪ R, contact slow against the material's relaxation.
/// Limit:   λ = 0 is Hertz; small λ follows e = 1 − C₁ β + (3/5) C₁² β²
///          -> test KuwabaraKonoTest.SmallDampingFollowsTheSeries.
/// Caution: the force pulls before x = 0 on rebound: the separation rule
///          decides e.
/// Source:  Kuwabara & Kono 1987; Brilliantov et al. 1996; Hanley et al., Eq. (5).
struct HertzDamped {
  double stiffness = 0.0;
  double damping = 0.0;

  static LawCard card();
  static HertzDamped from(const ParameterValues& values);

  double elastic_force(double x) const { return stiffness * x * std::sqrt(std::abs(x)); }
  double damping_force(double x, double v) const { return damping * std::sqrt(std::abs(x)) * v; }
  double force(double x, double v) const {
    return std::sqrt(std::abs(x)) * (stiffness * x + damping * v);
  }
  ForceSlopes at_root(double u, double v) const {
    const double root = std::abs(u);
    const double elastic = stiffness * u * u * u, lost = damping * root * v;
    return {elastic + lost, lost, 1.5 * elastic + 0.5 * lost, damping * root};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    return parameter == 0 ? u * u * u : std::abs(u) * v;
  }
  double elastic_energy(double x) const { return 0.4 * stiffness * x * x * std::sqrt(std::abs(x)); }
};

static_assert(ContactLaw<HertzDamped>);

}  // namespace rebound
