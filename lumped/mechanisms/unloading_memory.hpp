#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/problem/mechanisms.hpp"

/// Elastic force below the largest deflection so far, x_max.
///
///   F = F_e(η) [1 − h (1 − η/x_max)] + F_e(x_max) (x_max/x_q)^q g(u)
///   η = ⟨(x − p x_max)/(1 − p)⟩,   u = 1 − √(1 − η/x_max)
///
///   p   permanent set: residual over largest deflection [-]
///   h   hysteresis: share of the force lost at η → 0    [-]
///   g   curve, as a share of the force at the largest deflection, and how it grows with that:
///       q = 0 is the same loop at every speed, q > 0 the loop of a body that yields [-]
///
/// Points that are even in u stand close where unloading begins, which is where measured loops turn
/// fastest; in time u is smooth there, since x_max − x grows as t². A share of the largest force
/// stays smooth where unloading ends, too: as a factor on F_e(η), what ends early runs to minus one
/// within the last hundredth of the deflection, where no points are.
///
/// At x = x_max the force is F_e(x_max): loading is the law's own, unloading
/// and reloading run on this curve until x passes x_max. For F_e = κ xⁿ and
/// h = 0 it is F_max [(x − p x_max)/((1 − p) x_max)]ⁿ. Damping stays at x.
/// Valid:   0 ≤ p < 1, 0 ≤ h ≤ 1; rate-independent; a curve that ends at zero, so that the force
///          has no jump where unloading begins.
/// Limit:   of an elastic law with set, e² = 1 − p and the dent left is p x_max
///          -> test PermanentSetTest.LeavesItsShareOfTheLargestDeflection.
///          A line g = −h (1 − u) leaves a Hertz contact e² = 1 − s^2.5 − (5/3) h (1 − s)^1.5,
///          s^1.5 = h √(1 − s) -> test FactorCurveTest.ALineOfTheUnloadingLosesWhatItsIntegralSays.
/// Caution: with both, hysteresis works on the deflection that is left, η.
/// Source:  unloading from a permanently flattened contact, as in the loading
///          and unloading curves of Walton & Braun 1986, for any law.
namespace rebound {

/// Deflection that is left of x for the elastic force [m]; negative once the
/// ball has come away from the dent, so that this can be watched.
inline double remaining_deflection(const UnloadingMemory& memory, double x, double largest) {
  const double p = memory.permanent_set;
  return p == 0.0 ? x : (x - p * largest) / (1.0 - p);
}

/// u of a share η/x_max, and back.
inline double unloading_place(double share) {
  return 1.0 - std::sqrt(std::max(0.0, 1.0 - share));
}
inline double unloading_share(double place) {
  return 1.0 - (1.0 - place) * (1.0 - place);
}

/// Factor of hysteresis on the elastic force at the remaining deflection η; even in η, as laws are
/// continued oddly below zero.
inline double hysteresis_factor(const UnloadingMemory& memory, double remaining, double largest) {
  if (memory.hysteresis == 0.0 || largest <= 0.0) return 1.0;
  return 1.0 - memory.hysteresis * (1.0 - std::abs(remaining) / largest);
}

/// Share of the force at the largest deflection that the curve adds at η; its first point below
/// zero.
inline double unloading_share_of_force(const UnloadingMemory& memory, double remaining,
                                       double largest) {
  if (memory.curve.end == 0.0 || largest <= 0.0) return 0.0;
  const double growth = memory.curve_growth == 0.0
                            ? 1.0
                            : std::pow(largest / memory.growth_deflection, memory.curve_growth);
  return growth * curve_value(memory.curve, unloading_place(std::max(0.0, remaining) / largest));
}

}  // namespace rebound
