#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// Neo-Hookean solid with an isochoric–volumetric split.
///
///   W = μ/2 (Ī₁ − 3) + K/2 (J − 1)²,      Ī₁ = J^(−2/3) tr C
///   S_d = μ J^(−2/3) (1 − (I₁/3) C⁻¹),    S_v = K (J − 1) J C⁻¹
///
///   μ shear modulus, K bulk modulus [Pa]; S second Piola–Kirchhoff [Pa]
///
/// Valid:   J > 0; softens in volume under strong compression (W stays finite
///          as J → 0), so runs with large volume change end in inversion
///          sooner than with NeoHookean.
/// Limit:   small strain is isotropic elasticity -> test MaterialBattery.SmallStrain
/// Source:  Holzapfel, Nonlinear Solid Mechanics (2000), §6.4–6.5.
struct NeoHookeanIsochoric {
  Moduli moduli;

  template <class T>
  Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    const T scale = moduli.shear * exp((-2.0 / 3.0) * e.log_jacobian);
    const T mean = (c.rr + c.zz + c.tt) * (1.0 / 3.0);
    return {scale * (1.0 - mean * e.inverse.rr), scale * (1.0 - mean * e.inverse.zz),
            scale * (1.0 - mean * e.inverse.tt), -scale * mean * e.inverse.rz};
  }

  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    const T factor = moduli.bulk * (e.jacobian - 1.0) * e.jacobian;
    return {factor * e.inverse.rr, factor * e.inverse.zz, factor * e.inverse.tt,
            factor * e.inverse.rz};
  }

  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    return 0.5 * moduli.shear * (exp((-2.0 / 3.0) * e.log_jacobian) * (c.rr + c.zz + c.tt) - 3.0);
  }

  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    const T change = e.jacobian - 1.0;
    return 0.5 * moduli.bulk * change * change;
  }

  /// As NeoHookean::stiffness_growth, with t = tr F⁻¹h, q = tr(F⁻¹h F⁻¹h)
  ///
  ///   A(h) = μ J^(−2/3) (|h|² − (4/3) t F:h + (2/9) I₁ t² + (1/3) I₁ q)
  ///        + K (2J² − J) t² + K (1 − J) J q
  ///
  /// and the largest value along principal directions, where t F:h = k.
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T& m) const {
    const auto& c = e.right_cauchy_green;
    const double mu = moduli.shear;
    const T j = e.jacobian;
    const T scale = mu * exp((-2.0 / 3.0) * e.log_jacobian);
    const T invariant = c.rr + c.zz + c.tt;
    const T pressure = moduli.bulk * j * (j < 1.0 ? 1.0 - j : j - 1.0);
    const T shear = scale * (1.0 + (1.0 / 3.0) * invariant * m) + pressure * m;
    const T per_trace =
        (2.0 / 9.0) * scale * invariant + moduli.bulk * j * (j < 0.5 ? 0.0 * j : 2.0 * j - 1.0);
    const T in_plane = e.inverse.rr + e.inverse.zz;
    const T one = shear - (4.0 / 3.0) * scale + per_trace * m;
    const T wave = (one > shear ? one : shear) * (1.0 / (moduli.bulk + 4.0 / 3.0 * mu));
    const T plane = (shear - (8.0 / 3.0) * scale + per_trace * in_plane) *
                    (1.0 / (2.0 * moduli.bulk + 2.0 / 3.0 * mu));
    const T swelling =
        (shear - 4.0 * scale + per_trace * (in_plane + e.inverse.tt)) * (1.0 / (3.0 * moduli.bulk));
    const T larger = wave > plane ? wave : plane;
    return larger > swelling ? larger : swelling;
  }
};

}  // namespace rebound::fem
