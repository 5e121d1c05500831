#pragma once

#include <gtest/gtest.h>

#include "fem/schemes/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound::test {

/// The common case of the verification ladder: R = 33.1 mm, m = 89.6 g,
/// E = 10 MPa, ν = 0.4.
inline FemProblem common_case(double speed) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = speed;
  problem.material = {.youngs_modulus = 10e6, .poisson_ratio = 0.4};
  return problem;
}

/// Runs the impact and holds it to what every complete run must satisfy:
/// contact force against momentum, and energy with all channels booked.
inline FemResult checked_impact(const Mesh& mesh, const FemProblem& problem) {
  const auto body = fem::discretise(mesh, problem.sphere.mass);
  FemResult result = fem::run_explicit_impact(body, problem, {});
  EXPECT_EQ(result.incomplete_because, "");
  EXPECT_LE(result.closures.impulse, 1e-6);
  EXPECT_LE(result.closures.energy, 1e-3);
  EXPECT_NEAR(result.scalars.restitution, result.restitution_momentum, 1e-6);
  EXPECT_LE(result.contact_constraint_share, 3.2e-3);
  return result;
}

}  // namespace rebound::test
