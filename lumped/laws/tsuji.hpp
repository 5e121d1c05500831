#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Hertz contact with the damping of discrete-element codes: a restitution
/// that does not depend on the impact speed.
///
///   F = κ x^{3/2} + λ x^{1/4} ẋ,    λ = α √(m κ)
///
///   κ   stiffness, (4/3) E* √R on a rigid plate   [N/m^1.5]
///   λ   damping                                   [N s/m^1.25]
///   α   damping number                            [-]
///
/// In w = x^{5/4} the phase plane (w, ẋ) is that of linear Kelvin–Voigt with
/// ζ = α/√5: restitution under either separation rule is that of ζ.
///
/// Valid:   where a restitution constant in speed is wanted; no material
///          theory gives the power ¼.
/// Limit:   λ = 0 is Hertz; e(α) of Kelvin–Voigt at ζ = α/√5
///          -> test TsujiTest.RestitutionIsThatOfKelvinVoigt.
/// Caution: the force pulls before x = 0 on rebound: codes that clip the
///          tension separate at zero force and return more than asked for.
/// Source:  Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011 for the
///          transformation.
struct Tsuji {
  double stiffness = 0.0;
  double damping = 0.0;

  static LawCard card();
  static Tsuji from(const ParameterValues& values);
  /// Formula "exact" only: inverts e(ζ) under the separation rule of the impact.
  static double damping_for(const DampingRequest& request);

  double elastic_force(double x) const { return stiffness * x * std::sqrt(std::abs(x)); }
  double damping_force(double x, double v) const {
    return damping * std::sqrt(std::sqrt(std::abs(x))) * v;
  }
  double force(double x, double v) const {
    const double root = std::sqrt(std::abs(x));
    return stiffness * x * root + damping * std::sqrt(root) * v;
  }
  ForceSlopes at_root(double u, double v) const {
    const double quarter = std::sqrt(std::abs(u));
    const double elastic = stiffness * u * u * u, lost = damping * quarter * v;
    return {elastic + lost, lost, 1.5 * elastic + 0.25 * lost, damping * quarter};
  }
  double slope_by(std::size_t parameter, double u, double v) const {
    return parameter == 0 ? u * u * u : std::sqrt(std::abs(u)) * v;
  }
  double elastic_energy(double x) const { return 0.4 * stiffness * x * x * std::sqrt(std::abs(x)); }
};

static_assert(ContactLaw<Tsuji>);

}  // namespace rebound
