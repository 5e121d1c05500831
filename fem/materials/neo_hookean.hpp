#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// Compressible neo-Hookean solid, split so that either part may relax.
///
///   W = μ/2 (I₁ − 3 − 2 ln J) + λ/2 (ln J)²,      λ = K − 2μ/3
///   deviatoric part  W_d = μ/2 (I₁ − 3 − 2 ln J) − μ/3 (ln J)²,
///                    S_d = μ (1 − C⁻¹) − (2/3) μ ln J C⁻¹
///   volumetric part  W_v = K/2 (ln J)²,   S_v = K ln J C⁻¹
///
///   μ shear modulus, K bulk modulus [Pa]; S second Piola–Kirchhoff [Pa]
///
/// Valid:   J > 0. The split is by modulus: scaling S_d scales μ at constant K.
/// Limit:   small strain is isotropic elasticity -> test MaterialBattery.SmallStrain
/// Caution: W_d is not isochoric at finite strain; for a pure isochoric
///          split take NeoHookeanIsochoric.
/// Source:  Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element
///          Analysis, 2nd ed. (2008), §6.4.3.
struct NeoHookean {
  Moduli moduli;

  template <class T>
  Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const T factor = moduli.shear * (1.0 + (2.0 / 3.0) * e.log_jacobian);
    return {moduli.shear - factor * e.inverse.rr, moduli.shear - factor * e.inverse.zz,
            moduli.shear - factor * e.inverse.tt, -factor * e.inverse.rz};
  }

  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    const T factor = moduli.bulk * e.log_jacobian;
    return {factor * e.inverse.rr, factor * e.inverse.zz, factor * e.inverse.tt,
            factor * e.inverse.rz};
  }

  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    return moduli.shear * (0.5 * (c.rr + c.zz + c.tt - 3.0) - e.log_jacobian -
                           e.log_jacobian * e.log_jacobian / 3.0);
  }

  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return 0.5 * moduli.bulk * e.log_jacobian * e.log_jacobian;
  }

  /// Growth of the stiffest motions since rest; drives the stable step.
  ///
  ///   A(h) = μ |h|² + (μ − λ ln J) tr(F⁻¹h F⁻¹h) + λ (tr F⁻¹h)²
  ///   growth = largest over k = 1, 2, 3 of max A_k / (2μ + k|λ|)
  ///
  ///   A  tangent ∂P/∂F as a quadratic form of unit h; A_k where k principal
  ///      directions change length: 1 wave, 2 in the plane, 3 swelling
  ///   m  upper bound of the eigenvalues of C⁻¹
  ///
  /// Limit:   1 at rest; bounds the squared speed of every wave
  ///          -> test MaterialBattery.GrowthBoundsWaves
  /// Caution: for the frequency of a cell an estimate, short by 3 % at most in
  ///          random strains of 0.6 -> test StableStep.FrequencyOfDeformedCell
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T& m) const {
    const double lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
    const double size = lame < 0.0 ? -lame : lame;
    const T geometric = moduli.shear - lame * e.log_jacobian;
    const T shear = moduli.shear + (geometric < 0.0 ? -geometric : geometric) * m;
    const T in_plane = e.inverse.rr + e.inverse.zz;
    const T wave = (shear + size * m) * (1.0 / (2.0 * moduli.shear + size));
    const T plane = (shear + size * in_plane) * (1.0 / (2.0 * moduli.shear + 2.0 * size));
    const T swelling =
        (shear + size * (in_plane + e.inverse.tt)) * (1.0 / (2.0 * moduli.shear + 3.0 * size));
    const T larger = wave > plane ? wave : plane;
    return larger > swelling ? larger : swelling;
  }
};

}  // namespace rebound::fem
