#pragma once

namespace rebound::fem {

/// Static contact of a sphere in linear elasticity, on the cells and with the
/// contact of the implicit scheme: what the scheme gives where strain is linear.
///
///   K₀ u = reactions of the plate,   K₀ the tangent at rest
///
/// Limit:   agrees with a small-strain computation made apart
///          -> test RungC.LinearKinematicsAgreeWithASmallStrainComputation.
/// Caution: the plate pushes along its own normal, not along the sphere's. At finite
///          strain the surface turns until both are one; linear theory cannot, and the
///          difference is of the order of the finite-sphere correction.
struct LinearContact {
  double radius = 0.0;          ///< [m]
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;
  int platens = 1;              ///< 1: on one plate, held by a uniform body force; 2: between two
  double approach = 0.0;        ///< of the plate and the centre of mass (1) or the middle plane (2) [m]
  int cells = 400;              ///< about
  double grading = 1.5;         ///< of the mesh
};

/// Force of the plate [N].
/// Errors: Error(solver_failed) where the active set does not settle.
double linear_contact_force(const LinearContact& problem);

}  // namespace rebound::fem
