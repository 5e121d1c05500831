#pragma once

#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// The factor that strain, and the largest strain so far, put on an elastic law.
///
///   S = f S_elastic,   f = g(ε) [1 − d (1 − ε/ε_m)],   ε = √(2 W/E)
///   g = 1 + a ε − b (1 − e^(−20 ε)) + c ⟨ε − 1/4⟩²
///   Ψ = ∫₀^W f dW at fixed ε_m,   dissipation = −∂Ψ/∂ε_m dε_m/dt ≥ 0
///
///   ε    effective strain: the axial one under small uniaxial stress [-]
///   ε_m  the largest ε of this point so far [-]
///   W    energy of the elastic law [J/m³], E its Young's modulus [Pa]
///   a ≥ 0 stiffening, 0 ≤ b < 1 softening toward a plateau, c ≥ 0
///   densification, 0 ≤ d ≤ 1 Mullins softening, all zero: the law alone [-]
///
/// The same functions that the effects put on a lumped force, with ε in place of
/// x/R. On first loading ε = ε_m and Mullins softening does nothing.
///
/// Valid:   any isotropic law with W ≥ 0.
/// Limit:   small strain is the law: f = 1 at ε = 0 -> test StrainFactorTest.*
/// Caution: ε does not know compression from extension; c stiffens both. Mullins
///          softening is pseudo-elastic: it depends on ε_m alone and never heals.
/// Source:  energy of an energy: Ogden & Roxburgh 1999 (d); the shapes of
///          a, b, c are those of comparisons/models/effects.
struct StrainFactor {
  double stiffening = 0.0;      ///< a
  double softening = 0.0;       ///< b
  double densification = 0.0;   ///< c
  double mullins = 0.0;         ///< d
  double youngs_modulus = 1.0;  ///< E of the law that W belongs to [Pa]
};

inline constexpr double softening_rate = 20.0;
inline constexpr double densification_strain = 0.25;

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
  FactorAt<T> at;
  const T floor = 0.0 * w;
  const T positive = w > 0.0 ? w : floor;
  at.strain = sqrt(T((2.0 / k.youngs_modulus) * positive + 1e-40));
  at.largest_strain = at.strain > largest_before ? at.strain : largest_before;
  const T fade = exp(T(-softening_rate * at.strain));
  const T over = at.strain > densification_strain ? T(at.strain - densification_strain) : floor;
  const T g =
      1.0 + k.stiffening * at.strain - k.softening * (1.0 - fade) + k.densification * over * over;
  const T damage = 1.0 - k.mullins * (1.0 - at.strain / at.largest_strain);
  at.value = g * damage;
  // W is a difference of numbers near 1: below 1e-7 the strain is rounding, and
  // would be divided by.
  constexpr double rounding = 1e-7;
  at.slope = (k.stiffening + 2.0 * k.densification * over +
              k.mullins * g / (at.largest_strain + rounding)) /
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
  const T first = 0.5 * e2 + (k.stiffening / 3.0) * e3 -
                  k.softening * (0.5 * e2 - (1.0 - (1.0 + r * e) * fade) * (1.0 / (r * r))) +
                  k.densification * y3 * (0.25 * y + e0 / 3.0);
  const T second =
      (1.0 / 3.0) * e3 + (k.stiffening / 4.0) * e4 -
      k.softening * ((1.0 / 3.0) * e3 -
                     (2.0 - (r * r * e2 + 2.0 * r * e + 2.0) * fade) * (1.0 / (r * r * r))) +
      k.densification * y3 * (0.2 * y * y + 0.5 * e0 * y + e0 * e0 / 3.0);
  return {first, second};
}

/// What Mullins softening has taken by now: the first loading up to ε_m less Ψ there, a function
/// of ε_m alone since nothing is lost below it [J/m³].
///
///   D_m = E d [∫₀^ε_m g ε dε − (1/ε_m) ∫₀^ε_m g ε² dε]
///
/// Limit: with Ψ it is the work of any path -> test StrainFactorTest.WorkIsStoredAndSoftened
template <class T>
inline T softened_energy(const StrainFactor& k, const FactorAt<T>& at) {
  const StrainMoments<T> m = strain_moments(k, at.largest_strain);
  return k.youngs_modulus * k.mullins * (m.first - m.second / at.largest_strain);
}

/// Ψ per reference volume [J/m³]: what unloading gives back.
template <class T>
inline T factored_energy(const StrainFactor& k, const FactorAt<T>& at) {
  const StrainMoments<T> m = strain_moments(k, at.strain);
  return k.youngs_modulus *
         ((1.0 - k.mullins) * m.first + k.mullins / at.largest_strain * m.second);
}

}  // namespace rebound::fem
