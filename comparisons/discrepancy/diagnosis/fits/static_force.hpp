#pragma once

#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// Force of a lumped model that is loaded slowly, from zero to one deflection.
///
///   F(x) = F_e(x) [1 + Σ s_i (τ_i/T) (1 − e^(−T/τ_i))]
///
///   x    deflection of one contact                             [m]
///   T    duration of a loading whose elastic force grows evenly [s]
///   F_e  elastic force with its factors on deflection, of a relaxed body [N]
///   s, τ ratio and time of each relaxing branch, of the law or beside it [-], [s]
///
/// Damping does not act, nor does inertia. A stiffness that follows the impact speed is taken at
/// the reference speed: a power of the speed says nothing of a test a hundred thousand times
/// slower.
///
/// Valid:   rigid platens; the finite sphere's compliance and a pull are left out.
/// Limit:   T ≫ τ is the relaxed force, T ≪ τ the instantaneous one
///          -> test StaticForceTest.RelaxesFromInstantaneousToRelaxed.
/// Errors:  Error(bad_input) as make_law() and ElasticForce.
/// Source:  Maxwell branch under a force that grows evenly.
double static_force(const LumpedProblem& problem, double deflection, double duration);

}  // namespace rebound
