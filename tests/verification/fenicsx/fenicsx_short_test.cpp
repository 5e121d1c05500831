// The deck of `rebound export --to fenicsx`, run by FEniCSx: coarse, so that it takes seconds. What
// is asked for is what 60 nine-node cells resolve: the force rides on the ripple of the contact
// front, 2.8 and 1.6 % too high.
#include <gtest/gtest.h>

#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "tests/verification/fenicsx/fenicsx_run.hpp"

namespace rebound {
namespace {

TEST(FenicsxDeck, CoarseImpactsAgree) {
  for (const bool relaxes : {false, true}) {
    FemProblem problem = test::ball_at_15();
    problem.cells = 60;
    if (relaxes) problem.material.branches = {{.ratio = 0.3, .relaxation_time = 0.3e-3}};
    const test::FenicsxResult found = test::run_fenicsx(problem);
    problem.cells = 500;
    const FemResult own = fem_tier().simulate(problem, mesh_for(problem), {});
    EXPECT_NEAR(found.restitution, own.restitution_momentum, 2e-3) << relaxes;
    EXPECT_NEAR(found.peak_deflection / own.scalars.peak_deflection, 1.0, 2e-3) << relaxes;
    EXPECT_NEAR(found.peak_force / own.scalars.peak_force, 1.0, 4e-2) << relaxes;
  }
}

}  // namespace
}  // namespace rebound
