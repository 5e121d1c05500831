#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/mechanisms/elastic_factors.hpp"
#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/mechanisms/reference_scales.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// C of a damper without a formula; 0: there is none [N s/m].
template <class Law>
double added_damping_coefficient(const Law& law, const DampingFactors& factors, double radius) {
  if (factors.added.end == 0.0 || factors.rate_curve.end == 0.0) return 0.0;
  const double reach = std::pow(factors.added.end, 4) * radius;
  return law.elastic_force(reach) / factors.rate_curve.end;
}

/// Damping force of a law with its factors, and dampers beside it.
///
///   [F_d (x/x_r)^a |ẋ/v_r|^b · g(x/R) + C d((x/R)^(1/4)) ẋ] · curve(|ẋ|) + c ẋ
///
///   x, ẋ   deflection [m] and its rate [m/s] as the law sees them
///   g      elastic_factor of what the damping follows: Hunt and Crossley's grows with all of F_e,
///          Tsuji's with none of it
///   d      values of a curve [-], over the fourth root: a dashpot is constant in it, Tsuji's
///          x^(1/4) ẋ a line and √x ẋ a parabola, so that none of them is steep at first touch
///   C      F_e(x_end)/v_end, force of the law over rate at the ends of d and of curve(|ẋ|) [N s/m]
///   c      dashpot [N s/m]
///
/// Valid:   n_d + a ≥ 0 with n_d the exponent of F_d g in x: no infinite force at
///          first touch (checked when the contact is composed); b > −1.
/// Limit:   a = b = c = 0 is the law's own damping -> test EffectBattery.NullLeavesAllAsItWas; a
///          line d is Tsuji's damper -> test FactorCurveTest.ALineOfDampingIsTsujis.
/// Caution: with a dashpot, d(0) or n_d + a = 0, the force jumps at first touch
///          and pulls before the end: the separation rule decides e.
template <class Law>
double damping_force(const Law& law, const DampingFactors& factors, double added_coefficient,
                     double radius, double x, double rate) {
  double at = x;
  // Not at x = 0, where F_d and a power are 0 · ∞ although the product is finite.
  if (factors.exponent != 0.0 || factors.elastic.exponent != 0.0)
    at = std::max(std::abs(x), 1e-12 * radius);
  double force = law.damping_force(at, rate);
  if (factors.exponent != 0.0)
    force *= std::pow(at / (reference_deflection_share * radius), factors.exponent);
  if (factors.velocity_exponent != 0.0)
    force *=
        rate == 0.0 ? 0.0 : std::pow(std::abs(rate) / reference_speed, factors.velocity_exponent);
  force *= elastic_factor(factors.elastic, std::abs(at) / radius);
  if (added_coefficient != 0.0)
    force += added_coefficient *
             curve_value(factors.added, std::sqrt(std::sqrt(std::abs(x) / radius))) * rate;
  return force * curve_factor(factors.rate_curve, std::abs(rate)) + factors.dashpot * rate;
}

}  // namespace rebound
