#pragma once

#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/principal_stretches.hpp"
#include "fem/materials/volumetric_law.hpp"

namespace rebound::fem {

/// Ogden solid with an isochoric–volumetric split.
///
///   W_d = Σᵢ (2μᵢ/αᵢ²) (λ̄₁^αᵢ + λ̄₂^αᵢ + λ̄₃^αᵢ − 3),   λ̄ = J^(−1/3) λ,   μ = Σ μᵢ
///   S_d = Σᵢ (2μᵢ/αᵢ) J^(−αᵢ/3) C^(αᵢ/2 − 1) − c C⁻¹,   c so that S_d : C = 0
///   W_v = K/4 (J² − 1 − 2 ln J)
///
///   μᵢ > 0 shear modulus of a term [Pa], αᵢ ≠ 0 its exponent
///
/// Valid:   J > 0.
/// Limit:   α = 2: neo-Hookean; 2 and −2: Mooney–Rivlin -> tests MaterialLimits
/// Caution: Ogden's own convention is W = Σ (μ'ᵢ/αᵢ)(…) with 2μ = Σ μ'ᵢ αᵢ: μᵢ = μ'ᵢ αᵢ/2.
/// Source:  Ogden 1972; Holzapfel, Nonlinear Solid Mechanics (2000), §6.5.
struct Ogden {
  Moduli moduli;
  StretchTerms terms;

  template <class T>
  [[gnu::always_inline]] Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    const T zero = 0.0 * e.jacobian;
    Symmetric<T> sum{zero, zero, zero, zero};
    T mean = zero;
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term], factor = 2.0 * terms.shear[term] / alpha;
      T value[3];
      for (int i = 0; i < 3; ++i) {
        const T power = factor * exp(T(alpha * (p.logarithm[i] - (1.0 / 3.0) * e.log_jacobian)));
        mean = mean + (1.0 / 3.0) * power;
        value[i] = power * p.inverse_square[i];
      }
      add_power(p, value, 0.5 * alpha - 1.0, sum);
    }
    return {sum.rr - mean * e.inverse.rr, sum.zz - mean * e.inverse.zz,
            sum.tt - mean * e.inverse.tt, sum.rz - mean * e.inverse.rz};
  }

  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    return stress_of_volume(e, moduli.bulk);
  }

  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    T energy = 0.0 * e.jacobian;
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term];
      T sum = energy * 0.0 - 3.0;
      for (int i = 0; i < 3; ++i)
        sum = sum + exp(T(alpha * (p.logarithm[i] - (1.0 / 3.0) * e.log_jacobian)));
      energy = energy + 2.0 * terms.shear[term] / (alpha * alpha) * sum;
    }
    return energy;
  }

  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return energy_of_volume(e, moduli.bulk);
  }

  /// growth_of with t(λ) = Σ (2μᵢ/αᵢ) J^(−αᵢ/3) λ^αᵢ and Gᵢ = λᵢ t'(λᵢ).
  template <class T>
  [[gnu::always_inline]] T stiffness_growth(const Strain<T>& e, const T&) const {
    const PrincipalStretches<T> p = principal_stretches_of(e);
    const T zero = 0.0 * e.jacobian;
    StretchTangent<T> tangent;
    tangent.slope = zero;
    T g[3];
    for (int i = 0; i < 3; ++i) {
      tangent.inverse_square[i] = p.inverse_square[i];
      tangent.stress[i] = g[i] = zero;
    }
    for (int term = 0; term < terms.count; ++term) {
      const double alpha = terms.exponent[term], mu = terms.shear[term];
      T slope[3];
      for (int i = 0; i < 3; ++i) {
        const T power = exp(T(alpha * (p.logarithm[i] - (1.0 / 3.0) * e.log_jacobian)));
        tangent.stress[i] = tangent.stress[i] + 2.0 * mu / alpha * power;
        g[i] = g[i] + 2.0 * mu * power;
        slope[i] = 2.0 * mu * (alpha - 1.0) / alpha * power * p.inverse_square[i];
      }
      tangent.slope = tangent.slope + largest_of(slope[0], slope[1], slope[2]);
    }
    close_isochoric(tangent, g, e.jacobian, moduli.bulk);
    return growth_of(tangent, moduli.shear, moduli.bulk - 2.0 / 3.0 * moduli.shear);
  }
};

}  // namespace rebound::fem
