#pragma once

#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/principal_stretches.hpp"

namespace rebound::fem {

/// Ogden–Storåkers compressible foam.
///
///   W = Σᵢ (2μᵢ/αᵢ²) [λ₁^αᵢ + λ₂^αᵢ + λ₃^αᵢ − 3 + (J^(−αᵢβᵢ) − 1)/βᵢ]
///   S = Σᵢ (2μᵢ/αᵢ) [C^(αᵢ/2 − 1) − J^(−αᵢβᵢ) C⁻¹]
///   μ = Σ μᵢ,   K = Σ 2μᵢ (1/3 + βᵢ),   βᵢ = νᵢ/(1 − 2νᵢ)
///   volumetric part  W_v = K/2 (ln J)², deviatoric part the rest
///
///   μᵢ > 0 [Pa], αᵢ ≠ 0, βᵢ > −1/3; β = 0 stands for its limit, −αᵢ ln J
///
/// Valid:   J > 0. A foam that densifies needs a term with a negative or a
///          large exponent beside the one of the plateau.
/// Limit:   one β: lateral stretch λ^(−ν) under uniaxial stress
///          -> test MaterialLimits.HyperfoamKeepsItsPoissonRatio
/// Caution: the split is by modulus, as NeoHookean's, not isochoric.
/// Source:  Storåkers 1986; Hill 1978.
struct Hyperfoam {
  Moduli moduli;  ///< of the terms
  StretchTerms terms;

  template <class T>
  [[gnu::always_inline]] Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    const T zero = 0.0 * e.jacobian;
    Symmetric<T> sum{zero, zero, zero, zero};
    T constant = moduli.bulk * e.log_jacobian;
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term], factor = 2.0 * terms.shear[term] / alpha;
      T value[3];
      for (int i = 0; i < 3; ++i)
        value[i] = factor * exp(T(alpha * p.logarithm[i])) * p.inverse_square[i];
      add_power(p, value, 0.5 * alpha - 1.0, sum);
      constant = constant + factor * exp(T(-alpha * terms.beta[term] * e.log_jacobian));
    }
    return {sum.rr - constant * e.inverse.rr, sum.zz - constant * e.inverse.zz,
            sum.tt - constant * e.inverse.tt, sum.rz - constant * e.inverse.rz};
  }

  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    const T factor = moduli.bulk * e.log_jacobian;
    return {factor * e.inverse.rr, factor * e.inverse.zz, factor * e.inverse.tt,
            factor * e.inverse.rz};
  }

  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    T energy = -0.5 * moduli.bulk * e.log_jacobian * e.log_jacobian;
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term], beta = terms.beta[term];
      T sum = e.log_jacobian * -alpha;
      if (beta > 1e-9 || beta < -1e-9)  // of the model, not of a point
        sum = (exp(T(-alpha * beta * e.log_jacobian)) - 1.0) * (1.0 / beta);
      for (int i = 0; i < 3; ++i) sum = sum + exp(T(alpha * p.logarithm[i])) - 1.0;
      energy = energy + 2.0 * terms.shear[term] / (alpha * alpha) * sum;
    }
    return energy;
  }

  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return 0.5 * moduli.bulk * e.log_jacobian * e.log_jacobian;
  }

  /// growth_of with t(λ) = Σ (2μᵢ/αᵢ) λ^αᵢ, c = Σ (2μᵢ/αᵢ) J^(−αᵢβᵢ) and
  /// coupling Σ 2μᵢβᵢ J^(−αᵢβᵢ).
  template <class T>
  [[gnu::always_inline]] T stiffness_growth(const Strain<T>& e, const T&) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    const T zero = 0.0 * e.jacobian;
    StretchTangent<T> tangent;
    tangent.slope = tangent.constant = tangent.coupling = tangent.spread = zero;
    for (int i = 0; i < 3; ++i) {
      tangent.inverse_square[i] = p.inverse_square[i];
      tangent.stress[i] = zero;
    }
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term], mu = terms.shear[term], beta = terms.beta[term];
      T slope[3];
      for (int i = 0; i < 3; ++i) {
        const T power = exp(T(alpha * p.logarithm[i]));
        tangent.stress[i] = tangent.stress[i] + 2.0 * mu / alpha * power;
        slope[i] = 2.0 * mu * (alpha - 1.0) / alpha * power * p.inverse_square[i];
      }
      tangent.slope = tangent.slope + largest_of(slope[0], slope[1], slope[2]);
      const T volume = 2.0 * mu * exp(T(-alpha * beta * e.log_jacobian));
      tangent.constant = tangent.constant + volume * (1.0 / alpha);
      tangent.coupling = tangent.coupling + volume * beta;
    }
    return growth_of(tangent, moduli.shear, moduli.bulk - 2.0 / 3.0 * moduli.shear);
  }
};

}  // namespace rebound::fem
