#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Hertz contact of a sphere of a standard linear solid, with one state of its own.
///
///   F + τ Ḟ = κ x^{3/2} + τ (1 + s) κ d(x^{3/2})/dt,   that is
///   F = κ x^{3/2} + q,   q̇ = s κ d(x^{3/2})/dt − q/τ
///
///   κ   long-term stiffness, (4/3) E* √R              [N/m^1.5]
///   s   branch over long-term stiffness; (1 + s) κ is the instantaneous one [-]
///   τ   relaxation time                               [s]
///
/// Valid:   while the contact grows this is Lee and Radok's integral exactly
///          -> test VerificationCaseE.TheLawIsExactWhileTheContactGrows.
/// Limit:   s = 0, or τ far below the contact time, is Hertz of κ; τ far above it, Hertz
///          of (1 + s) κ -> tests StandardLinearSolidTest.NoBranchIsHertz, SlowBranchIsStiffer.
/// Caution: while the contact shrinks Ting's integral forgets the area that has let go, and
///          this law does not: restitution is 0.018 to 0.024 too low for s = 1, τ = 1 ms on a
///          sliotar core. foundation_impact.hpp has the exact answer. `force` is the part
///          without the state; F falls to zero at x > 0.
/// Source:  Lee & Radok 1960; Ting 1966; standard linear solid as in Fung 1993.
struct StandardLinearSolid {
  double stiffness = 0.0;
  double ratio = 0.0;
  double relaxation_time = 1.0;

  static LawCard card();
  static StandardLinearSolid from(const ParameterValues& values);

  RelaxationBranch branch() const { return {.ratio = ratio, .relaxation_time = relaxation_time}; }
  double elastic_force(double x) const { return stiffness * x * std::sqrt(std::abs(x)); }
  double damping_force(double, double) const { return 0.0; }
  double force(double x, double) const { return elastic_force(x); }
  ForceSlopes at_root(double u, double) const {
    const double elastic = stiffness * u * u * u;
    return {.force = elastic, .damping = 0.0, .by_log_deflection = 1.5 * elastic, .by_speed = 0.0};
  }
  double slope_by(std::size_t parameter, double u, double) const {
    return parameter == 0 ? u * u * u : 0.0;
  }
  double elastic_energy(double x) const { return 0.4 * stiffness * x * x * std::sqrt(std::abs(x)); }
};

static_assert(ContactLaw<StandardLinearSolid>);

}  // namespace rebound
