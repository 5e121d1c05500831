#pragma once

#include <cmath>
#include <limits>

#include "fem/interface/moduli.hpp"
#include "fem/materials/principal_stretches.hpp"

namespace rebound::fem {

/// A viscoelastic branch by the multiplicative split F = Fₑ Fᵥ.
///
///   ε = ½ ln(F Cᵥ⁻¹ Fᵀ),   W_b = μ_b |dev ε|² + (K_b/2) (tr ε)²
///   J σ = 2μ_b dev ε + K_b tr ε 1
///   flow at frozen F:  ε̇ = −(ε/τ) (q/q₀)^(1/m − 1)   (or dev ε alone)
///   q = √(2/3) √(|dev ε|² + (K_b/2μ_b) (tr ε)²)
///
///   ε      elastic strain of the branch (Hencky), Cᵥ = FᵥᵀFᵥ its viscous strain
///   τ      relaxation time at q = q₀ [s]; for m = 1 at any q
///   m      rate exponent: flow strain ∝ rate^m. 1 Newtonian, below 1 a power law,
///          toward 0 a plastic network that yields at q₀
///   K_b    zero when the branch relaxes the deviator alone [Pa]
///
/// The flow is integrated exactly at frozen F, half a step before the stress and
/// half after: second order in the step, dissipation −ΔW_b of each half never
/// negative -> test MultiplicativeBranch.*. Cᵥ stays symmetric and positive.
///
/// Valid:   any stretch and rate; the branch is Hencky's, whose stress falls
///          beyond an elastic stretch of e.
/// Limit:   small strain and m = 1 is the Prony branch
///          -> test MultiplicativeBranch.SmallStrainIsTheConvolution
/// Caution: at finite strain the instantaneous response is the elastic law's by the
///          long-term share and Hencky's by the rest, not the law's alone.
/// Source:  Reese & Govindjee 1998 (split, flow rule, update by logarithms);
///          Hencky energy as in Simo 1992.
struct BranchFlow {
  double before = 0.0;        ///< Δt/2τ of the step that led here [-]
  double next = 0.0;          ///< Δt/2τ of the step that follows [-]
  double decay_before = 1.0;  ///< e^(−before)
  double decay_next = 1.0;    ///< e^(−next)
  double power = 0.0;         ///< 1/m − 1; 0 Newtonian
  /// ln of the (q/q₀)^p below which nothing flows over both: least_flowing_exponent().
  double least_exponent = -std::numeric_limits<double>::infinity();
  double reference_strain = 1.0;  ///< q₀
};

/// Below it |p| x (q/q₀)^p does not reach 2⁻⁵⁴, and 1 + p x (q/q₀)^p is 1.
inline double least_flowing_exponent(const BranchFlow& flow) {
  return std::log(0x1p-54 / (std::abs(flow.power) * (flow.before + flow.next)));
}

/// Logarithm of a symmetric positive tensor: mean of the plane, its traceless
/// part N, and the hoop; beside it the tensor's largest value in the plane, and its determinant
/// there.
template <class T>
struct Logarithm {
  T plane_mean, n_rr, n_rz, hoop, half_difference;
  T largest, plane_determinant;
};

template <class T>
inline Logarithm<T> logarithm_of(const Symmetric<T>& b) {
  const T mean = 0.5 * (b.rr + b.zz), a = 0.5 * (b.rr - b.zz);
  const T root_squared = a * a + b.rz * b.rz;
  const T root = sqrt(T(root_squared + 1e-40 * mean * mean));
  Logarithm<T> l;
  l.largest = mean + root;
  l.plane_determinant = b.rr * b.zz - b.rz * b.rz;
  l.plane_mean = 0.5 * log(l.plane_determinant);
  l.half_difference = log(l.largest) - l.plane_mean;
  const T inverse_mean = 1.0 / mean;
  const T z = root_squared * inverse_mean * inverse_mean;
  const T series =  // artanh(√z)/√z
      (1.0 + z * (1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0))))) * inverse_mean;
  const T quotient = l.half_difference / root;
  const T per_root = z < 1e-3 ? series : quotient;
  l.n_rr = per_root * a;
  l.n_rz = per_root * b.rz;
  l.hoop = log(b.tt);
  return l;
}

/// Shares of the elastic strain that a flow leaves: after the first half step, after both.
template <class T>
struct SharesLeft {
  T first, both;
  bool all = false;  ///< nothing flows that a double could tell from 1, in no lane
};

/// Flow over x = Δt/τ at frozen F, first half and both halves by one power.
///
///   q' = q [1 + p x (q/q₀)^p]^(−1/p),   p = 1/m − 1
///
/// Limit: x = 0 leaves 1; below |p| x (q/q₀)^p = 2⁻⁵⁴ the bracket is 1 to the last bit
///        -> test MultiplicativeBranch.BelowItsYieldNothingFlows
template <class T>
inline SharesLeft<T> shares_left(const T& q_squared, const BranchFlow& flow) {
  const double p = flow.power, x = flow.before + flow.next;
  const T one = 0.0 * q_squared + 1.0;
  const T exponent =
      (0.5 * p) *
      log(T((q_squared + 1e-60) * (1.0 / (flow.reference_strain * flow.reference_strain))));
  if (!any_above(exponent, flow.least_exponent)) return {one, one, true};
  const T most = 0.0 * exponent + 300.0, least = 0.0 * exponent - 690.0;
  const T rate = p * exp(larger_of(T(exponent < 300.0 ? exponent : most), least));
  const auto left = [&](double over) {
    const T base = 1.0 + over * rate;
    return exp(T((-1.0 / p) * log(larger_of(base, T(0.0 * base + 1e-30)))));
  };
  return {left(flow.before), left(x)};
}

template <class T>
struct BranchPoint {
  Symmetric<T> stress;           ///< S, second Piola–Kirchhoff [Pa]
  Symmetric<T> inverse_viscous;  ///< Cᵥ⁻¹ half a step on
  T energy;                      ///< W_b where the stress is taken [J/m³]
  T dissipated;                  ///< over both half steps [J/m³], never negative
  T dissipated_before;           ///< over the first of them, up to where the stress is taken
  T growth;                      ///< as stiffness_growth, over the branch at rest [-]
};

/// F⁻¹, by one division.
template <class T>
inline Gradient<T> inverse_of(const Gradient<T>& f) {
  const T in_plane = f.rr * f.zz - f.rz * f.zr;
  const T inverse_jacobian = 1.0 / (in_plane * f.tt);
  const T scale = inverse_jacobian * f.tt;
  return {f.zz * scale, -f.rz * scale, -f.zr * scale, f.rr * scale, inverse_jacobian * in_plane};
}

/// G A Gᵀ, with G = F⁻¹ a pull back.
template <class T>
inline Symmetric<T> moved_by(const Gradient<T>& g, const Symmetric<T>& a) {
  const T p = g.rr * a.rr + g.rz * a.rz, q = g.rr * a.rz + g.rz * a.zz;
  const T s = g.zr * a.rr + g.zz * a.rz, t = g.zr * a.rz + g.zz * a.zz;
  return {p * g.rr + q * g.rz, s * g.zr + t * g.zz, g.tt * g.tt * a.tt, p * g.zr + q * g.zz};
}

template <class T>
inline T branch_growth(const Logarithm<T>& l, const Symmetric<T>& b,
                       const Symmetric<T>& inverse_viscous, const Moduli& moduli) {
  // W_λᵢ = (2μ ln λᵢ − c)/λᵢ: a single term whose slope (1 − ln λ)/λ² falls up to λ = e^1.5.
  const T logs[3] = {0.5 * (l.plane_mean + l.half_difference),
                     0.5 * (l.plane_mean - l.half_difference), 0.5 * l.hoop};
  StretchTangent<T> tangent;
  T slope[3];
  const T trace = logs[0] + logs[1] + logs[2];
  const T inverse = 1.0 / (l.largest * l.plane_determinant * b.tt);  // one division for three
  const T inverse_plane = inverse * b.tt;
  tangent.inverse_square[0] = inverse_plane * l.plane_determinant;
  tangent.inverse_square[1] = inverse_plane * l.largest * l.largest;
  tangent.inverse_square[2] = inverse * l.largest * l.plane_determinant;
  for (int i = 0; i < 3; ++i) {
    tangent.stress[i] = 2.0 * moduli.shear * logs[i];
    slope[i] = 2.0 * moduli.shear * (1.0 - logs[i]) * tangent.inverse_square[i];
  }
  tangent.slope = largest_of(slope[0], slope[1], slope[2]);
  const double lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  tangent.constant = -lame * trace;
  tangent.coupling = 0.0 * trace + lame;
  tangent.spread = 0.0 * trace;
  // |h Fᵥ⁻¹|² ≤ |h|² times the largest eigenvalue of Cᵥ⁻¹.
  const auto& v = inverse_viscous;
  const T in_plane =
      0.5 * (v.rr + v.zz) + sqrt(T(0.25 * (v.rr - v.zz) * (v.rr - v.zz) + v.rz * v.rz + 1e-40));
  return growth_of(tangent, moduli.shear, lame) * larger_of(in_plane, v.tt);
}

/// One point over one step; `inverse_viscous` is Cᵥ⁻¹ half a step back.
template <class T>
inline BranchPoint<T> advance_multiplicative(const Gradient<T>& f,
                                             const Symmetric<T>& inverse_viscous,
                                             const Moduli& moduli, const BranchFlow& flow) {
  const Symmetric<T> b = moved_by(f, inverse_viscous);
  const Logarithm<T> l = logarithm_of(b);
  // ε = ½ ln b: mean third of its trace, deviator.
  const T third = (1.0 / 6.0) * (2.0 * l.plane_mean + l.hoop);
  const T plane = 0.5 * l.plane_mean - third, hoop = 0.5 * l.hoop - third;
  const T n_rr = 0.5 * l.n_rr, n_rz = 0.5 * l.n_rz;
  const T deviator = 2.0 * (plane * plane + n_rr * n_rr + n_rz * n_rz) + hoop * hoop;
  const bool all = moduli.bulk > 0.0;
  const T volume = all ? T(0.5 * moduli.bulk / moduli.shear * 9.0 * third * third) : T(0.0 * third);
  const T q_squared = (2.0 / 3.0) * (deviator + volume);
  SharesLeft<T> shares{0.0 * third + flow.decay_before,
                       0.0 * third + flow.decay_before * flow.decay_next};
  if (flow.power != 0.0) shares = shares_left(q_squared, flow);  // of the branch, not of a point
  const T left = shares.first, both = shares.both;
  BranchPoint<T> point;
  point.growth = branch_growth(l, b, inverse_viscous, moduli);
  const T twice = 2.0 * moduli.shear * left;
  const T pressure = 3.0 * moduli.bulk * left * third;
  const Gradient<T> inverse = inverse_of(f);
  point.stress = moved_by(
      inverse, Symmetric<T>{twice * (plane + n_rr) + pressure, twice * (plane - n_rr) + pressure,
                            twice * hoop + pressure, twice * n_rz});
  const T at_start = moduli.shear * (deviator + volume);
  point.energy = at_start * left * left;
  point.dissipated_before = at_start * (1.0 - left * left);
  point.dissipated = at_start * (1.0 - both * both);
  if (shares.all) {
    point.inverse_viscous = inverse_viscous;
    return point;
  }
  // b after both halves: exp(2ε'), the volume kept where only the deviator flows.
  const T mean = all ? T(both * third) : third;
  const T scale = exp(T(2.0 * (both * plane + mean)));
  const T w2 = 4.0 * both * both * (n_rr * n_rr + n_rz * n_rz);
  const T w = sqrt(T(w2 + 1e-40));
  const T e = exp(w), inverse_e = 1.0 / e;
  const T series = 1.0 + w2 * (1.0 / 6.0 + w2 * (1.0 / 120.0 + w2 * (1.0 / 5040.0)));
  const T quotient = 0.5 * (e - inverse_e) / w;
  const T sinhc = w2 < 1e-3 ? series : quotient;
  const T cosh = 0.5 * (e + inverse_e);
  const T shear = 2.0 * both * scale * sinhc;
  point.inverse_viscous =
      moved_by(inverse, Symmetric<T>{scale * cosh + shear * n_rr, scale * cosh - shear * n_rr,
                                     exp(T(2.0 * (both * hoop + mean))), shear * n_rz});
  return point;
}

}  // namespace rebound::fem
