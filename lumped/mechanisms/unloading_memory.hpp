#pragma once

#include <cmath>

#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/problem/mechanisms.hpp"

/// Elastic force below the largest deflection so far, x_max.
///
///   F = F_e(η) [1 − h (1 − η/x_max)] · curve(η/x_max),   η = ⟨(x − p x_max)/(1 − p)⟩
///
///   p   permanent set: residual over largest deflection [-]
///   h   hysteresis: share of the force lost at η → 0    [-]
///
/// At x = x_max the force is F_e(x_max): loading is the law's own, unloading
/// and reloading run on this curve until x passes x_max. For F_e = κ xⁿ and
/// h = 0 it is F_max [(x − p x_max)/((1 − p) x_max)]ⁿ. Damping stays at x.
/// Valid:   0 ≤ p < 1, 0 ≤ h ≤ 1; rate-independent; a curve that ends at zero, so that the force
///          has no jump where unloading begins.
/// Limit:   of an elastic law with set, e² = 1 − p and the dent left is p x_max
///          -> test PermanentSetTest.LeavesItsShareOfTheLargestDeflection.
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

/// Factor on the elastic force at the remaining deflection η; even in η, as laws
/// are continued oddly below zero.
inline double hysteresis_factor(const UnloadingMemory& memory, double remaining, double largest) {
  if (!memory.weakens() || largest <= 0.0) return 1.0;
  const double share = std::abs(remaining) / largest;
  return (1.0 - memory.hysteresis * (1.0 - share)) * curve_factor(memory.curve, share);
}

}  // namespace rebound
