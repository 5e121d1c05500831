#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/explicit/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::test {

/// Runs the impact and holds it to what every complete run must satisfy:
/// contact force against momentum, and energy with all channels counted.
inline FemResult checked_impact(const Mesh& mesh, const FemProblem& problem) {
  const auto body = fem::discretise(mesh, problem.sphere.mass);
  FemResult result = fem::run_explicit_impact(body, problem, {});
  EXPECT_EQ(result.incomplete_because, "");
  EXPECT_LE(result.closures.impulse, 1e-6);
  EXPECT_LE(result.closures.energy, 1e-3);
  EXPECT_NEAR(result.scalars.restitution, result.restitution_momentum, 1e-6);
  // 3e-3 at working resolution; the catch of a node goes with the cell size.
  EXPECT_LE(result.contact_constraint_share,
            3e-3 * std::sqrt(std::max(1.0, 1000.0 / result.cells)));
  return result;
}

}  // namespace rebound::test
