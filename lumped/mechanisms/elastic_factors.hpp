#pragma once

#include <cmath>

#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/mechanisms/reference_scales.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Product of the factors on the elastic force that depend on deflection.
///
///   (x/x_r)^a · [1 + b (x/R) (x/x_r)^(p − 1)] · {1 − c [1 − e^(−x/(c_x R))]} · (1 + d ⟨x/R −
///   d_x⟩²) · (1 + l e^(−x/(l_x R))) · curve(x/R)
///
///   ratio   x/R, ≥ 0 [-]       x_r = R/10       ⟨·⟩ positive part
///
/// Valid:   any law; a power law of exponent n stays one of exponent n + a.
/// Limit:   all numbers zero give exactly 1 -> test ElasticForceTest.NoFactorIsTheLaw.
/// Caution: x^a is singular at x = 0 for a < 0; the caller leaves out x = 0.
inline double elastic_factor(const ElasticFactors& factors, double ratio) {
  double product = 1.0;
  if (factors.exponent != 0.0)
    product *= std::pow(ratio / reference_deflection_share, factors.exponent);
  if (factors.stiffening_power == 1.0)
    product *= 1.0 + factors.stiffening * ratio;
  else if (factors.stiffening != 0.0)
    product *=
        1.0 + factors.stiffening * ratio *
                  std::pow(ratio / reference_deflection_share, factors.stiffening_power - 1.0);
  if (factors.softening != 0.0)
    product *= 1.0 - factors.softening * (1.0 - std::exp(-ratio / factors.softening_depth));
  if (const double beyond = ratio - factors.densification_onset;
      factors.densification != 0.0 && beyond > 0.0)
    product *= 1.0 + factors.densification * beyond * beyond;
  if (factors.layer != 0.0) product *= 1.0 + factors.layer * std::exp(-ratio / factors.layer_depth);
  return product * curve_factor(factors.curve, ratio);
}

/// Factor on the stiffness at impact speed v₀: (v₀/v_r)^r, constant over one impact.
///
/// Limit: v₀ = v_r gives 1 whatever r -> test ElasticForceTest.RateFactorIsOneAtTheReferenceSpeed.
inline double rate_factor(const ElasticFactors& factors, double speed) {
  return factors.rate_exponent == 0.0 ? 1.0
                                      : std::pow(speed / reference_speed, factors.rate_exponent);
}

}  // namespace rebound
