#pragma once

#include "lumped/problem/impact.hpp"

/// Restitution of the laws that have it in closed form, and its inverses.
/// No integrator is involved: these check the integrators.
namespace rebound {

/// Restitution of Hunt–Crossley, any exponent.
///
///   p (1 + e) = ln[(1 + p)/(1 − p e)],   p = λ v₀/κ
///
/// Valid:  p ≥ 0. Relative error below 1e-12, checked against 14-digit
///         direct integration -> test ExactRestitutionTest.HuntCrossleyTable.
/// Limit:  e → 1 − (2/3) p as p → 0 -> test ExactRestitutionTest.HuntCrossleyLowLoss.
/// Errors: Error(bad_input) for p < 0 or not finite.
/// Source: integral of m v dv/dx = −xⁿ(κ + λ v) over both branches.
double hunt_crossley_restitution(double damping_number);

/// The damping number p that returns e; inverse of hunt_crossley_restitution.
/// Errors: Error(bad_input) outside 1e-6 ≤ e ≤ 1.
double hunt_crossley_damping_number(double restitution);

/// Restitution of linear Kelvin–Voigt, ζ = λ/(2√(κ m)).
///
///   zero deflection   e = exp(−π ζ/√(1 − ζ²)),                 ζ < 1
///   zero force        e = exp(−2 ζ acos(ζ)/√(1 − ζ²)),         continued by acosh for ζ ≥ 1
///
/// Limit:   ζ → 0 gives 1 under both -> test ExactRestitutionTest.KelvinVoigtTable.
/// Errors:  Error(solver_failed) for ζ ≥ 1 under zero deflection: an
///          overdamped contact never returns to zero deflection.
double kelvin_voigt_restitution(double damping_ratio, SeparationRule rule);

/// The damping ratio ζ that returns e under the rule.
/// Errors: Error(bad_input) outside 1e-6 ≤ e ≤ 1.
double kelvin_voigt_damping_ratio(double restitution, SeparationRule rule);

/// acos(ζ)/√(1 − ζ²), continued through ζ = 1 by acosh(ζ)/√(ζ² − 1): half of
/// ωₙ t_c of linear Kelvin–Voigt under the zero-force rule.
double kelvin_voigt_half_phase(double damping_ratio);

}  // namespace rebound
