#pragma once

#include "lumped/laws/exact_restitution.hpp"
#include "lumped/laws/hunt_crossley.hpp"
#include "lumped/laws/linear_kelvin_voigt.hpp"
#include "lumped/problem/impact.hpp"

/// Impacts that have a closed form or a plain quadrature. They check the
/// integrators and never take part in a simulation; the FE tier has no access.
namespace rebound {

/// Mass and approach speed of an impact.
struct Approach {
  double mass = 0.0;   ///< [kg]
  double speed = 0.0;  ///< [m/s]
};

/// State of the ball during contact.
struct ContactState {
  double deflection = 0.0;  ///< [m]
  double velocity = 0.0;    ///< closing positive [m/s]
  double force = 0.0;       ///< [N]
};

/// Linear Kelvin–Voigt impact.
///
///   x(t) = v₀ e^{−ζ ωₙ t} sin(ω_d t)/ω_d,   ωₙ = √(κ/m),  ζ = λ/(2√(κ m)),  ω_d = ωₙ √(1 − ζ²)
///
///   zero deflection: ωₙ t_c = π/√(1 − ζ²);   zero force: ωₙ t_c = 2 acos(ζ)/√(1 − ζ²)
///
/// Valid:   any ζ; sin → sinh, acos → acosh beyond ζ = 1.
/// Limit:   e(ζ) and ωₙ t_c(ζ) of a table of ten ζ
///          -> test ClosedFormsTest.KelvinVoigtTable.
/// Errors:  Error(solver_failed) for ζ ≥ 1 under zero deflection.
/// Source:  Hanley et al., Eqs (11)–(13), corrected to take the rule into account.
class KelvinVoigtImpact {
 public:
  KelvinVoigtImpact(const LinearKelvinVoigt& law, const Approach& approach);
  double damping_ratio() const { return zeta_; }
  ContactState at(double time) const;
  double contact_time(SeparationRule rule) const;
  double restitution(SeparationRule rule) const { return kelvin_voigt_restitution(zeta_, rule); }

 private:
  LinearKelvinVoigt law_;
  Approach approach_;
  double frequency_;  ///< ωₙ [rad/s]
  double zeta_;
};

/// Elastic impact under F = κ xⁿ (Hertz for n = 1.5).
struct ElasticImpact {
  double peak_deflection = 0.0;  ///< [m]
  double peak_force = 0.0;       ///< [N]
  double contact_time = 0.0;     ///< [s]
};

///   x_m = [(n+1) m v₀²/(2κ)]^{1/(n+1)},   F_m = κ x_mⁿ,
///   t_c = (2√π/(n+1)) Γ(1/(n+1))/Γ(1/(n+1) + ½) x_m/v₀
///
/// Damping of the law is ignored.
/// Limit:  n = 1.5: t_c = 2.94327518432 x_m/v₀ -> test ClosedFormsTest.HertzConstants.
/// Source: energy conservation; Hertz 1882 for n = 1.5.
ElasticImpact elastic_impact(const HuntCrossley& law, const Approach& approach);

/// Hunt–Crossley impact through its implicit relation of deflection and speed.
///
///   x^{n+1} = (m (n+1) κ/λ²) [ (p − ln(1+p)) − (w − ln(1+w)) ],  p = λ v₀/κ,  w = λ ẋ/κ
///   t = ∫ m dv / [xⁿ (κ + λ v)]
///
/// Valid:   p ≥ 1e-6; below it use elastic_impact, which differs by p.
/// Limit:   p → 0 is Hertz -> test ClosedFormsTest.HuntCrossleyWithoutLossIsHertz.
/// Caution: the published relation has λ ε/(m²(n+1)) where the derivation
///          gives λ²/(m²(n+1)).
/// Errors:  Error(bad_input) for p outside its range.
/// Source:  Marhefka & Orin 1996; Hanley et al., Eq. (7), with λ².
class HuntCrossleyImpact {
 public:
  HuntCrossleyImpact(const HuntCrossley& law, const Approach& approach);
  double damping_number() const { return p_; }
  double restitution() const { return restitution_; }
  double peak_deflection() const { return deflection(0.0); }
  double peak_force() const;
  double contact_time() const;
  /// From first touch to the largest deflection [s].
  double time_to_peak() const;
  /// Deflection where the closing speed is v, in [−e v₀, v₀] [m].
  double deflection(double velocity) const;

 private:
  double loading_deflection(double lost_speed) const;
  double unloading_deflection(double speed_to_gain) const;

  HuntCrossley law_;
  Approach approach_;
  double p_;
  double restitution_;
};

}  // namespace rebound
