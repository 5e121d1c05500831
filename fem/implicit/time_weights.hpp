#pragma once

namespace rebound::fem {

/// Weights of the generalised-α method.
///
///   α_m = (2ρ − 1)/(ρ + 1),   α_f = ρ/(ρ + 1),
///   γ = ½ − α_m + α_f,        β = ¼ (1 − α_m + α_f)²
///
///   ρ  what a step keeps of a motion much faster than the step [-]
///
/// Limit:  second order in the step at any ρ
///         -> test VerificationCaseA.BothSchemesAreOfSecondOrderInTime
/// Source: Chung & Hulbert, J. Appl. Mech. 60 (1993) 371.
struct TimeWeights {
  double mass, force, gamma, beta;

  explicit constexpr TimeWeights(double kept)
      : mass((2.0 * kept - 1.0) / (kept + 1.0)),
        force(kept / (kept + 1.0)),
        gamma(0.5 - mass + force),
        beta(0.25 * (1.0 - mass + force) * (1.0 - mass + force)) {}
};

/// ρ = 0.9, and 0.5 of a body that hardly changes its volume: its volume rings far faster
/// than a step, hundreds of times as stiff as its shape, and at 0.9 that grows until cells
/// are turned inside out (Poisson ratio 0.499, 15 m/s, 60 cells; with 0.7 it does not).
constexpr TimeWeights time_weights(bool nearly_incompressible) {
  return TimeWeights(nearly_incompressible ? 0.5 : 0.9);
}

}  // namespace rebound::fem
