#pragma once

#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// Principal stretches of an axisymmetric state: two in the plane, the hoop third.
///
///   C in the plane = exp(L) (cosh w 1 + (sinh w / w) N),   N² = w² 1, tr N = 0
///   ln λ₁,₂ = (L ± w)/2,   λ₃ = √C_θθ
///
///   N  logarithm of C without its mean: smooth where λ₁ = λ₂, unlike the directions
///
/// The square root in w is kept off zero by 1e-20, so that derivatives taken by
/// automatic differentiation exist at equal stretches too.
template <class T>
struct PrincipalStretches {
  T logarithm[3];       ///< ln λ
  T inverse_square[3];  ///< 1/λ²
  T half_difference;    ///< w
  T n_rr, n_rz;         ///< N, with N_zz = −N_rr
};

// Inlined, as the stress and the growth of the laws that use it are: both need the same stretches,
// which the compiler then computes once.
template <class T>
[[gnu::always_inline]] inline PrincipalStretches<T> principal_stretches_of(const Strain<T>& e) {
  const auto& c = e.right_cauchy_green;
  PrincipalStretches<T> p;
  const T mean = 0.5 * (c.rr + c.zz);
  const T a = 0.5 * (c.rr - c.zz);
  const T root_squared = a * a + c.rz * c.rz;
  const T root = sqrt(T(root_squared + 1e-40 * mean * mean));
  const T largest = mean + root;
  const T log_hoop = 0.5 * log(c.tt);
  const T log_mean = e.log_jacobian - log_hoop;  // L
  const T w = log(largest) - log_mean;
  p.half_difference = w;
  p.logarithm[0] = 0.5 * (log_mean + w);
  p.logarithm[1] = 0.5 * (log_mean - w);
  p.logarithm[2] = log_hoop;
  const T inverse_largest = 1.0 / largest;
  p.inverse_square[0] = inverse_largest;
  p.inverse_square[1] = largest * c.tt / (e.jacobian * e.jacobian);
  p.inverse_square[2] = e.inverse.tt;
  const T inverse_mean = 1.0 / mean;
  const T z = root_squared * inverse_mean * inverse_mean;
  const T series =  // artanh(√z)/√z
      (1.0 + z * (1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0))))) * inverse_mean;
  const T quotient = w / root;
  const T per_root = z < 1e-3 ? series : quotient;
  p.n_rr = per_root * a;
  p.n_rz = per_root * c.rz;
  return p;
}

/// Adds the tensor with the principal values `value` = const · λ^(2k) to `sum`.
template <class T>
inline void add_power(const PrincipalStretches<T>& p, const T value[3], double k,
                      Symmetric<T>& sum) {
  const T mean = 0.5 * (value[0] + value[1]);
  const T x = k * p.half_difference;
  const T x2 = x * x;
  const T series =  // tanh(x)/x
      k * mean * (1.0 + x2 * (-1.0 / 3.0 + x2 * (2.0 / 15.0 - x2 * (17.0 / 315.0))));
  const T quotient = 0.5 * (value[0] - value[1]) / p.half_difference;
  const T slope = x2 < 1e-4 ? series : quotient;
  const T in_plane = slope * p.n_rr;
  sum.rr = sum.rr + mean + in_plane;
  sum.zz = sum.zz + mean - in_plane;
  sum.tt = sum.tt + value[2];
  sum.rz = sum.rz + slope * p.n_rz;
}

/// Tangent of an energy of principal stretches, in the parts that bound it.
/// With W_λᵢ = (t(λᵢ) − c)/λᵢ, t a sum of powers, and ∂²W/∂ln λᵢ∂ln λⱼ =
/// λ t'(λ) δᵢⱼ + cross terms + coupling.
template <class T>
struct StretchTangent {
  T slope;              ///< Σ over terms of the largest d(t/λ)/dλ [Pa]
  T stress[3];          ///< t(λᵢ) [Pa]
  T constant;           ///< c [Pa]
  T coupling;           ///< B of the form B (tr F⁻¹h)² [Pa]
  T spread;             ///< cross terms beyond those of an even G, see Ogden [Pa]
  T inverse_square[3];  ///< 1/λᵢ²
};

template <class T>
inline T larger_of(const T& a, const T& b) {
  return a > b ? a : b;
}

template <class T>
inline T largest_of(const T& a, const T& b, const T& c) {
  return larger_of(larger_of(a, b), c);
}

/// The parts of a tangent that an isochoric law shares with every other: with
/// Gᵢ = λᵢ t'(λᵢ), projected free of volume on both sides, and W_v of
/// volumetric_law.hpp.
///
///   c = mean t − K/2 (J² − 1),   B = K J² + Σ G/9 − (2/3) G₀
///   spread = (1/3) (G_max − G_min),   G₀ = (G_max + G_min)/2
template <class T>
inline void close_isochoric(StretchTangent<T>& a, const T g[3], const T& jacobian, double bulk) {
  const T square = jacobian * jacobian;
  a.constant =
      (1.0 / 3.0) * (a.stress[0] + a.stress[1] + a.stress[2]) - 0.5 * bulk * (square - 1.0);
  const T most = largest_of(g[0], g[1], g[2]);
  const T least = -largest_of(T(-g[0]), T(-g[1]), T(-g[2]));
  a.spread = (1.0 / 3.0) * (most - least);
  a.coupling = bulk * square + (1.0 / 9.0) * (g[0] + g[1] + g[2]) - (1.0 / 3.0) * (most + least);
}

/// Growth of the stiffest motions since rest; drives the stable step.
///
///   A(h) ≤ s |h|² + (B + spread) (tr F⁻¹h)²
///   growth = largest over k = 1, 2, 3 of max A_k / (2μ + kλ)
///
///   s  bound of (Wᵢ ∓ Wⱼ)/(λᵢ ∓ λⱼ) by the mean value theorem, each power
///      taken where it is largest
///   k  principal directions that change length, as in NeoHookean
///
/// Limit:   1 at rest; bounds the squared speed of every wave
///          -> test MaterialBattery.GrowthBoundsWaves
template <class T>
[[gnu::always_inline]] inline T growth_of(const StretchTangent<T>& a, double shear, double lame) {
  const auto& i = a.inverse_square;
  const T largest = largest_of(i[0], i[1], i[2]);
  const T pull =
      largest_of(T((a.stress[0] - a.constant) * i[0]), T((a.stress[1] - a.constant) * i[1]),
                 T((a.stress[2] - a.constant) * i[2]));
  const T push = largest_of(T(a.constant * i[0]), T(a.constant * i[1]), T(a.constant * i[2]));
  const T s = larger_of(T(a.slope + push), pull);
  const T zero = 0.0 * s;
  const T volume = a.spread + larger_of(a.coupling, zero);
  const double stiff = lame > 0.0 ? lame : 0.0;
  const T wave = (s + volume * largest) * (1.0 / (2.0 * shear + stiff));
  const T plane = (s + volume * (i[0] + i[1])) * (1.0 / (2.0 * shear + 2.0 * stiff));
  const T swelling = (s + volume * (i[0] + i[1] + i[2])) * (1.0 / (2.0 * shear + 3.0 * stiff));
  return largest_of(wave, plane, swelling);
}

}  // namespace rebound::fem
