#pragma once

#include "fem/materials/kinematics.hpp"
#include "fem/materials/moduli.hpp"

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

  /// As NeoHookean::stiffness_growth; the bulk term is U''J² = K J² and the
  /// pressure term K |J − 1| J, the shear terms are bounded by J^(−2/3) I₁.
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T& m) const {
    const auto& c = e.right_cauchy_green;
    const T j = e.jacobian;
    const T change = j < 1.0 ? 1.0 - j : j - 1.0;
    const T shear = moduli.shear * exp((-2.0 / 3.0) * e.log_jacobian);
    const T trace = e.inverse.rr + e.inverse.zz + e.inverse.tt;
    const T invariant = (c.rr + c.zz + c.tt) * (1.0 / 3.0);
    return (shear * (1.0 + invariant * m) + moduli.bulk * j * (j * trace + 2.0 * change * trace)) *
           (1.0 / (2.0 * moduli.shear + 3.0 * moduli.bulk));
  }
};

}  // namespace rebound::fem
