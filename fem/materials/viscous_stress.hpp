#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// Kelvin–Voigt viscous stress.
///
///   S = θ [2μ C⁻¹ĖC⁻¹ + (K − 2μ/3) (C⁻¹:Ė) C⁻¹]
///   which is  J σ = θ [2μ dev d + K tr d 1],   S : Ė = θ [2μ |dev d|² + K (tr d)²] ≥ 0
///
///   θ  retardation time [s], Ė rate of Green strain [1/s], d rate of
///      deformation; μ, K instantaneous moduli [Pa]
///
/// Valid:   any θ ≥ 0; the stable step falls as 2/ω (√(1 + ξ²) − ξ), ξ = θω/2.
/// Limit:   small strain σ = D (ε + θ ε̇) -> test ViscousStressTest.SmallStrain
/// Caution: the force at the first touch is θ-proportional and discontinuous.
template <class T>
inline Symmetric<T> viscous_stress(const Strain<T>& e, const Gradient<T>& f,
                                   const Gradient<T>& rate, const Moduli& moduli,
                                   double retardation_time) {
  const auto& i = e.inverse;
  // Ė = sym(Fᵀ Ḟ)
  const T rr = f.rr * rate.rr + f.zr * rate.zr;
  const T zz = f.rz * rate.rz + f.zz * rate.zz;
  const T rz = 0.5 * (f.rr * rate.rz + f.zr * rate.zz + f.rz * rate.rr + f.zz * rate.zr);
  const T tt = f.tt * rate.tt;
  const double twice = 2.0 * moduli.shear * retardation_time;
  const T trace = i.rr * rr + i.zz * zz + 2.0 * i.rz * rz + i.tt * tt;
  const T volume = (moduli.bulk - 2.0 / 3.0 * moduli.shear) * retardation_time * trace;
  // C⁻¹ĖC⁻¹ in the plane: columns of ĖC⁻¹ first
  const T a = rr * i.rr + rz * i.rz, b = rr * i.rz + rz * i.zz;
  const T c = rz * i.rr + zz * i.rz, d = rz * i.rz + zz * i.zz;
  return {twice * (i.rr * a + i.rz * c) + volume * i.rr,
          twice * (i.rz * b + i.zz * d) + volume * i.zz, twice * i.tt * i.tt * tt + volume * i.tt,
          twice * (i.rr * b + i.rz * d) + volume * i.rz};
}

/// Growth of the stiffest damping since rest, as NeoHookean::stiffness_growth.
template <class T>
inline T damping_growth(const Strain<T>& e, const T& m, const Moduli& moduli) {
  const double lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  const double size = lame > 0.0 ? lame : 0.0, twice = 2.0 * moduli.shear;
  const T plane_trace = e.inverse.rr + e.inverse.zz;
  const T wave = (twice * m + size * m) * (1.0 / (twice + size));
  const T plane = (twice * m + size * plane_trace) * (1.0 / (twice + 2.0 * size));
  const T swelling =
      (twice * m + size * (plane_trace + e.inverse.tt)) * (1.0 / (twice + 3.0 * size));
  const T larger = wave > plane ? wave : plane;
  return larger > swelling ? larger : swelling;
}

}  // namespace rebound::fem
