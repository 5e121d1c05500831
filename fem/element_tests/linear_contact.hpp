#pragma once

#include "fem/interface/element_checks.hpp"
#include "meshes/mesh.hpp"

namespace rebound::fem {

/// Static contact of a sphere in linear elasticity, on the cells and with the
/// contact of the implicit scheme: what the scheme gives where strain is linear.
///
///   K₀ u = reactions of the plate,   K₀ the tangent at rest
///
/// Limit:   agrees with a small-strain computation made apart
///          -> test VerificationCaseC.LinearKinematicsAgreeWithASmallStrainComputation.
/// Caution: the plate pushes along its own normal, not along the sphere's. At finite
///          strain the surface turns until both are one; linear theory cannot, and the
///          difference is of the order of the finite-sphere correction.
/// Errors: Error(solver_failed) where the active set does not settle.
double linear_contact_force(const Mesh& mesh, const LinearContact& contact);

}  // namespace rebound::fem
