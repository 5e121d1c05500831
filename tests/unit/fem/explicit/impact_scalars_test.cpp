// Scalars of whole impacts that rest on the impact and not on how it is asked for.
#include <gtest/gtest.h>

#include "fem/explicit/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

FemResult impact(const FemProblem& problem, int cells) {
  return run_explicit_impact(
      discretise(generate_sphere_mesh({.radius = 0.0331, .cells = cells}), problem.sphere.mass),
      problem, {});
}

// The peak is the largest mean over a window of the contact time, the contact time the end of the
// tail: samples further apart than the window leave them alone.
TEST(ImpactScalars, AreThoseOfAnyOutputInterval) {
  FemProblem problem = test::common_case(15.0);
  const FemResult by_default = impact(problem, 250);
  for (const double interval : {2e-6, 20e-6, 50e-6}) {
    problem.controls.output_interval = interval;
    const FemResult other = impact(problem, 250);
    EXPECT_NEAR(other.scalars.peak_force / by_default.scalars.peak_force, 1.0, 1e-6) << interval;
    EXPECT_NEAR(other.contact_time_tail / by_default.contact_time_tail, 1.0, 1e-6) << interval;
  }
}

// Instantaneous 0.4, relaxed 0.489: fully integrated cells would lock while the ball is on the
// plate, and the restitution of few cells would lie 2 % above that of many.
TEST(ImpactScalars, ABranchOfTheDeviatorDoesNotLock) {
  FemProblem problem = test::common_case(15.0);
  problem.material.branches = {{0.9, 1e-4, Relaxes::deviator}};
  const FemResult few = impact(problem, 250), many = impact(problem, 2000);
  EXPECT_NEAR(few.restitution_momentum / many.restitution_momentum, 1.0, 5e-4);
}

}  // namespace
}  // namespace rebound::fem
