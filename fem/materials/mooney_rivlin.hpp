#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/principal_stretches.hpp"
#include "fem/materials/volumetric_law.hpp"

namespace rebound::fem {

/// Mooney–Rivlin solid with an isochoric–volumetric split.
///
///   W_d = C₁₀ (Ī₁ − 3) + C₀₁ (Ī₂ − 3),    μ = 2 (C₁₀ + C₀₁)
///   S_d = 2 C₁₀ J^(−2/3) (1 − (I₁/3) C⁻¹)
///       + 2 C₀₁ J^(−4/3) (I₁ 1 − C − (2/3) I₂ C⁻¹)
///   W_v = K/4 (J² − 1 − 2 ln J)
///
///   Ī₁ = J^(−2/3) I₁, Ī₂ = J^(−4/3) I₂; moduli [Pa]; S second Piola–Kirchhoff [Pa]
///
/// Valid:   J > 0, 0 ≤ C₀₁/(C₁₀ + C₀₁) ≤ 1.
/// Limit:   S_d of Ogden with the exponents 2 and −2 -> test MaterialLimits.MooneyRivlinIsOgden
/// Caution: other codes have other volumetric laws; shear stresses agree, pressures
///          at large volume change do not.
/// Source:  Holzapfel, Nonlinear Solid Mechanics (2000), §6.5.
struct MooneyRivlin {
  Moduli moduli;
  double second_share = 0.0;  ///< C₀₁/(C₁₀ + C₀₁) [-]

  template <class T>
  Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    const double first = moduli.shear * (1.0 - second_share), second = moduli.shear * second_share;
    const T scale = exp(T((-2.0 / 3.0) * e.log_jacobian));
    const T one = first * scale, two = second * scale * scale;
    const T trace = c.rr + c.zz + c.tt;
    const T unit = one + two * trace;
    const T inverse = (1.0 / 3.0) * one * trace + (2.0 / 3.0) * two * second_invariant(c);
    return {unit - two * c.rr - inverse * e.inverse.rr, unit - two * c.zz - inverse * e.inverse.zz,
            unit - two * c.tt - inverse * e.inverse.tt, -two * c.rz - inverse * e.inverse.rz};
  }

  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    return stress_of_volume(e, moduli.bulk);
  }

  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    const T scale = exp(T((-2.0 / 3.0) * e.log_jacobian));
    const T first = scale * (c.rr + c.zz + c.tt) - 3.0;
    const T second = scale * scale * second_invariant(c) - 3.0;
    return 0.5 * moduli.shear * ((1.0 - second_share) * first + second_share * second);
  }

  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return energy_of_volume(e, moduli.bulk);
  }

  /// As Ogden's, with the exponents 2 and −2.
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T&) const {
    const auto& c = e.right_cauchy_green;
    const T mean = 0.5 * (c.rr + c.zz), a = 0.5 * (c.rr - c.zz);
    const T root = sqrt(T(a * a + c.rz * c.rz));
    const T scale = exp(T((2.0 / 3.0) * e.log_jacobian));
    const T first = moduli.shear * (1.0 - second_share) / scale;
    const T second = moduli.shear * second_share * scale;
    const T square[3] = {mean + root, e.jacobian * e.jacobian / (c.tt * (mean + root)), c.tt};
    StretchTangent<T> tangent;
    T g[3];
    for (int i = 0; i < 3; ++i) {
      tangent.inverse_square[i] = 1.0 / square[i];
      const T one = first * square[i], two = second * tangent.inverse_square[i];
      tangent.stress[i] = one - two;
      g[i] = 2.0 * (one + two);
    }
    const auto& inverse = tangent.inverse_square;
    const T largest = largest_of(inverse[0], inverse[1], inverse[2]);
    tangent.slope = first + 3.0 * second * largest * largest;
    close_isochoric(tangent, g, e.jacobian, moduli.bulk);
    return growth_of(tangent, moduli.shear, moduli.bulk - 2.0 / 3.0 * moduli.shear);
  }

 private:
  template <class T>
  static T second_invariant(const Symmetric<T>& c) {
    return c.rr * c.zz - c.rz * c.rz + (c.rr + c.zz) * c.tt;
  }
};

}  // namespace rebound::fem
