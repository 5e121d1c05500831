#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/mechanisms/reference_scales.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Damping force of a law with its factors, and a linear dashpot beside it.
///
///   F_d (x/x_r)^a |ẋ/v_r|^b · curve(√(x/R)) · curve(x/R) · curve(|ẋ|) + c ẋ
///
///   x, ẋ   deflection [m] and its rate [m/s] as the law sees them
///   c      dashpot [N s/m]
///
/// Valid:   n_d + a ≥ 0 with n_d the exponent of F_d in x: no infinite force at
///          first touch (checked when the contact is composed); b > −1.
/// Limit:   a = b = c = 0 is the law's own damping -> test EffectBattery.NullLeavesAllAsItWas.
/// Caution: with a dashpot, or with n_d + a = 0, the force jumps at first touch
///          and pulls before the end: the separation rule decides e.
template <class Law>
double damping_force(const Law& law, const DampingFactors& factors, double radius, double x,
                     double rate) {
  double force = 0.0;
  if (factors.exponent != 0.0) {
    // Not at x = 0, where F_d and the power are 0 · ∞ although the product is finite.
    const double at = std::max(std::abs(x), 1e-12 * radius);
    force = law.damping_force(at, rate) *
            std::pow(at / (reference_deflection_share * radius), factors.exponent);
  } else {
    force = law.damping_force(x, rate);
  }
  if (factors.velocity_exponent != 0.0)
    force *=
        rate == 0.0 ? 0.0 : std::pow(std::abs(rate) / reference_speed, factors.velocity_exponent);
  // Over the root: what differs from a law's damping does so most at first touch.
  force *= curve_factor(factors.deflection_curve, std::sqrt(std::abs(x) / radius)) *
           curve_factor(factors.elastic_curve, std::abs(x) / radius) *
           curve_factor(factors.rate_curve, std::abs(rate));
  return force + factors.dashpot * rate;
}

}  // namespace rebound
