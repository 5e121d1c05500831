#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/volumetric_law.hpp"

namespace rebound::fem {

// To add a material: bash comparisons/setup/new material NAME
/// A material to copy: it compiles, passes the battery, and is in no list. It is the least
/// solid there can be: a neo-Hookean deviator and a volumetric law.
///
///   W_d = μ/2 (Ī₁ − 3),   W_v = K/4 (J² − 1 − 2 ln J),   Ī₁ = J^(−2/3) tr C
///   S_d = μ J^(−2/3) (1 − (I₁/3) C⁻¹),   S_v = K/2 (J² − 1) C⁻¹
///
///   μ shear modulus, K bulk modulus [Pa]; S second Piola–Kirchhoff [Pa]
///
/// Valid:   where?
/// Limit:   what does it reduce to, and which test shows it?
/// Caution: what will surprise?
/// Source:  author, title, section.
struct BlankMaterial {
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
    return stress_of_volume(e, moduli.bulk);
  }
  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    const auto& c = e.right_cauchy_green;
    return 0.5 * moduli.shear * (exp((-2.0 / 3.0) * e.log_jacobian) * (c.rr + c.zz + c.tt) - 3.0);
  }
  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return energy_of_volume(e, moduli.bulk);
  }

  /// As NeoHookeanIsochoric::stiffness_growth, with the volumetric law's
  ///
  ///   A_v(h) = K J² (tr F⁻¹h)² − K/2 (J² − 1) tr(F⁻¹h F⁻¹h)
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T& m) const {
    const auto& c = e.right_cauchy_green;
    const double mu = moduli.shear;
    const T square = e.jacobian * e.jacobian;
    const T scale = mu * exp((-2.0 / 3.0) * e.log_jacobian);
    const T invariant = c.rr + c.zz + c.tt;
    const T pressure = 0.5 * moduli.bulk * (square < 1.0 ? T(1.0 - square) : T(square - 1.0));
    const T shear = scale * (1.0 + (1.0 / 3.0) * invariant * m) + pressure * m;
    const T per_trace = (2.0 / 9.0) * scale * invariant + moduli.bulk * square;
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
