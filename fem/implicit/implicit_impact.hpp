#pragma once

#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// Runs one impact by the generalised-α method on nine-node cells, with its own
/// contact. The second scheme: element, integrator, contact and tangent share
/// nothing with run_explicit_impact but the formulas of the materials.
///
///   M [(1 − α_m) a₁ + α_m a₀] + (1 − α_f) (f₁ − λ₁) + α_f (f₀ − λ₀) + M g = 0
///   u₁ = u₀ + Δt v₀ + Δt² [(½ − β) a₀ + β a₁],   v₁ = v₀ + Δt [(1 − γ) a₀ + γ a₁]
///   z ≥ 0, λ ≥ 0, z λ = 0 at every contact node at the end of every step
///
///   α_m = (2ρ − 1)/(ρ + 1), α_f = ρ/(ρ + 1), γ = ½ − α_m + α_f, β = ¼ (1 − α_m + α_f)²,
///   ρ = 0.9 the share of the highest frequencies that a step keeps
///   M mass [kg], f internal force, λ force of the plate [N], g gravity [m/s²]
///
/// Friction as ActiveSet has it, a plate that moves as PlateMotion.
/// Contact nodes have no axial inertia of their own (see BodyForces), so λ has
/// no spikes and no energy is lost in catching them. The step is a 200th of the
/// Hertz contact time times `step_safety`/0.9; a step that does not converge is
/// cut in halves, six times at most.
///
/// Result: as run_explicit_impact. Energy lost to the integrator is not counted:
///        it is what `closures.energy` shows.
/// Limit: elastic impact at low speed is Hertz with the finite-sphere
///        correction, time order 2 -> tests TwoSchemes, VerificationCaseA.
/// Errors: Error(bad_input) as run_explicit_impact, and for adhesion to a plate that
///        moves, viscous stress, Mullins softening, layers and multiplicative branches.
/// Source: Chung & Hulbert 1993.
FemResult run_implicit_impact(const Mesh& mesh, const FemProblem& problem,
                              const RunControl& control);

}  // namespace rebound::fem
