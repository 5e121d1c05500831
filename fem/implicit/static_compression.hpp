#pragma once

#include "fem/interface/compression.hpp"
#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// Presses a sphere without inertia, step by step.
///
///   f(u) = λ            between two platens: half of the sphere, its middle plane moved by x/2
///   f(u) = λ − F M 1/m  on one plate: a uniform body force F holds it, Σ λ = F,
///                       x the travel of the centre of mass
///   z ≥ 0, λ ≥ 0, z λ = 0 at every contact node; Coulomb friction as ActiveSet has it
///
///   f internal force, λ force of the plate [N], M mass [kg], x travel [m]
///
/// The slow path uses the long-term state; the others integrate the branches
/// exactly over each step. A path in time ends when the plate is left.
/// Limit:  Hertz as a/R → 0, the finite-sphere correction at small a/R
///         -> test VerificationCaseC; Ting's unloading -> test VerificationCaseEFem
/// Errors: Error(bad_input) for numbers out of range or a mesh that does not fit.
CompressionResult run_static_compression(const Mesh& mesh, const CompressionProblem& problem,
                                         const RunControl& control);

}  // namespace rebound::fem
