#pragma once

#include <array>

#include "fem/interface/material.hpp"
#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// A piecewise linear curve: its value at zero, and where its slope changes.
template <std::size_t Count>
struct Bends {
  bool act = false;
  double at_zero = 0.0;
  std::array<double, Count> place{};
  std::array<double, Count> change{};  ///< of the slope
  double steepest = 0.0;               ///< largest slope, not below zero
};

/// The factor that strain, and the largest strain so far, put on an elastic law.
///
///   S = f S_elastic,   f = g(ε) [1 − d (1 − η) + m(η)],   η = ε/ε_m,   ε = √(2 W/E)
///   g = 1 + a ε − b (1 − e^(−20 ε)) + c ⟨ε − 1/4⟩² + g₀ + Σ s_k ⟨ε − ε_k⟩
///   m = m₀ + Σ t_k ⟨η − η_k⟩,   m(1) = 0
///   Ψ = ∫₀^W f dW at fixed ε_m,   dissipation = −∂Ψ/∂ε_m dε_m/dt ≥ 0
///
///   ε    effective strain: the axial one under small uniaxial stress [-]
///   ε_m  the largest ε of this point so far [-]
///   W    energy of the elastic law [J/m³], E its Young's modulus [Pa]
///   a ≥ 0 stiffening, 0 ≤ b < 1 softening toward a plateau, c ≥ 0
///   densification, 0 ≤ d ≤ 1 Mullins softening, all zero: the law alone [-]
///   g₀, s_k  a curve without a formula: its value at rest and where it bends [-]
///   m₀, t_k  the same of the unloading, over the share η of the largest strain [-]
///
/// The same functions that the effects put on a lumped force, with ε in place of
/// x/R. On first loading ε = ε_m, and neither Mullins softening nor m does anything. An m that
/// falls toward η = 1 would give back more than was put in: that is not refused, but shows as
/// a negative dissipation.
///
/// Valid:   any isotropic law with W ≥ 0.
/// Limit:   small strain is the law: f = 1 at ε = 0 -> test StrainFactorTest.*
/// Caution: ε does not know compression from extension; c stiffens both. Mullins
///          softening is pseudo-elastic: it depends on ε_m alone and never heals.
/// Source:  energy of an energy: Ogden & Roxburgh 1999 (d); the shapes of
///          a, b, c are those of comparisons/models/effects.
struct StrainFactor {
  double stiffening = 0.0;                  ///< a
  double softening = 0.0;                   ///< b
  double densification = 0.0;               ///< c
  double mullins = 0.0;                     ///< d
  Bends<StrainCurve::points> curve;         ///< g₀, ε_k, s_k
  Bends<UnloadingCurve::points> unloading;  ///< m₀, η_k, t_k
  double youngs_modulus = 1.0;              ///< E of the law that W belongs to [Pa]
};

inline constexpr double softening_rate = 20.0;
inline constexpr double densification_strain = 0.25;

template <class T, std::size_t Count>
inline T value_of(const Bends<Count>& curve, const T& x) {
  const T zero = 0.0 * x;
  T sum = zero + curve.at_zero;
  for (std::size_t i = 0; i < Count; ++i)
    sum = sum + curve.change[i] * (x > curve.place[i] ? T(x - curve.place[i]) : zero);
  return sum;
}

template <class T>
struct FactorAt {
  T strain;          ///< ε
  T largest_strain;  ///< ε_m, this point included
  T value;           ///< f
  T slope;           ///< upper bound of (∂f/∂ε)/ε, for the stable step
};

/// f at the energy `w` of a point whose strain has been up to `largest_before`.
template <class T>
inline FactorAt<T> factor_at(const StrainFactor& k, const T& w, const T& largest_before) {
  // W is a difference of numbers near 1: below 1e-7 the strain is rounding, and
  // would be divided by.
  constexpr double rounding = 1e-7;
  FactorAt<T> at;
  const T floor = 0.0 * w;
  const T positive = w > 0.0 ? w : floor;
  at.strain = sqrt(T((2.0 / k.youngs_modulus) * positive + 1e-40));
  at.largest_strain = at.strain > largest_before ? at.strain : largest_before;
  const T over = at.strain > densification_strain ? T(at.strain - densification_strain) : floor;
  T g = 1.0 + k.stiffening * at.strain + k.densification * over * over;
  if (k.softening != 0.0) g = g - k.softening * (1.0 - exp(T(-softening_rate * at.strain)));
  T curve_slope = floor;
  if (k.curve.act) {
    g = g + value_of(k.curve, at.strain);
    curve_slope = floor + k.curve.steepest;
  }
  T damage = 1.0 + floor, unloading_slope = floor;
  if (k.mullins != 0.0 || k.unloading.act) {  // of the branch, not of a point: a division each
    const T share = at.strain / at.largest_strain;
    damage = 1.0 - k.mullins * (1.0 - share);
    if (k.unloading.act) damage = damage + value_of(k.unloading, share);
    unloading_slope = (k.mullins + k.unloading.steepest) * g / (at.largest_strain + rounding);
  }
  at.value = g * damage;
  at.slope = (k.stiffening + 2.0 * k.densification * over + curve_slope + unloading_slope) /
             (at.strain + rounding);
  return at;
}

/// ∫₀^ε g E ε dε and ∫₀^ε g E ε² dε, what Ψ is made of [J/m³].
template <class T>
struct StrainMoments {
  T first, second;
};
template <class T>
inline StrainMoments<T> strain_moments(const StrainFactor& k, const T& e) {
  const T e2 = e * e, e3 = e2 * e, e4 = e2 * e2;
  const T zero = 0.0 * e;
  constexpr double r = softening_rate, e0 = densification_strain;
  const T fade = exp(T(-r * e));
  const T y = e > e0 ? T(e - e0) : zero;
  const T y3 = y * y * y;
  T first = 0.5 * e2 + (k.stiffening / 3.0) * e3 -
            k.softening * (0.5 * e2 - (1.0 - (1.0 + r * e) * fade) * (1.0 / (r * r))) +
            k.densification * y3 * (0.25 * y + e0 / 3.0);
  T second = (1.0 / 3.0) * e3 + (k.stiffening / 4.0) * e4 -
             k.softening * ((1.0 / 3.0) * e3 -
                            (2.0 - (r * r * e2 + 2.0 * r * e + 2.0) * fade) * (1.0 / (r * r * r))) +
             k.densification * y3 * (0.2 * y * y + 0.5 * e0 * y + e0 * e0 / 3.0);
  if (k.curve.act) {
    first = first + 0.5 * k.curve.at_zero * e2;
    second = second + (1.0 / 3.0) * k.curve.at_zero * e3;
    for (std::size_t i = 0; i < StrainCurve::points; ++i) {
      const double from = k.curve.place[i], change = k.curve.change[i];
      const T above = e > from ? T(e - from) : zero;
      const T square = above * above;
      first = first + change * square * ((1.0 / 3.0) * above + 0.5 * from);
      second = second +
               change * square * (0.25 * square + (2.0 / 3.0) * from * above + 0.5 * from * from);
    }
  }
  return {first, second};
}

/// ∫₀^ε g E m ε dε at fixed ε_m: what a curve of the unloading adds to Ψ [J/m³, over E].
template <class T>
inline T unloading_moment(const StrainFactor& k, const T& e, const T& largest) {
  const StrainMoments<T> whole = strain_moments(k, e);
  T sum = k.unloading.at_zero * whole.first;
  for (std::size_t i = 0; i < UnloadingCurve::points; ++i) {
    const double share = k.unloading.place[i], change = k.unloading.change[i];
    const T bend = share * largest;
    const StrainMoments<T> before = strain_moments(k, T(e < bend ? e : bend));
    sum = sum + change * ((whole.second - before.second) / largest -
                          share * (whole.first - before.first));
  }
  return sum;
}

/// What softening of the unloading has taken by now: the first loading up to ε_m less Ψ there, a
/// function of ε_m alone since nothing is lost below it [J/m³].
///
///   D_m = E d [∫₀^ε_m g ε dε − (1/ε_m) ∫₀^ε_m g ε² dε] − E ∫₀^ε_m g m ε dε
///
/// Limit: with Ψ it is the work of any path -> test StrainFactorTest.WorkIsStoredAndSoftened
template <class T>
inline T softened_energy(const StrainFactor& k, const FactorAt<T>& at) {
  const StrainMoments<T> m = strain_moments(k, at.largest_strain);
  const T by_line = k.mullins * (m.first - m.second / at.largest_strain);
  if (!k.unloading.act) return k.youngs_modulus * by_line;
  return k.youngs_modulus * (by_line - unloading_moment(k, at.largest_strain, at.largest_strain));
}

/// Ψ per reference volume [J/m³]: what unloading gives back.
template <class T>
inline T factored_energy(const StrainFactor& k, const FactorAt<T>& at) {
  const StrainMoments<T> m = strain_moments(k, at.strain);
  const T by_line = (1.0 - k.mullins) * m.first + k.mullins / at.largest_strain * m.second;
  if (!k.unloading.act) return k.youngs_modulus * by_line;
  return k.youngs_modulus * (by_line + unloading_moment(k, at.strain, at.largest_strain));
}

}  // namespace rebound::fem
