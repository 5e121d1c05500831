// Rung e: a standard linear solid (instantaneous 20, long-term 10 MPa, τ 1 ms,
// ν 0.4, R 33.1 mm, m 89.6 g) on a rigid plate, by Lee–Radok and Ting. Targets:
// Ting's integral equations solved separately; impacts by another foundation.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/verification/lumped_rungs.hpp"
#include "comparisons/verification/targets.hpp"
#include "lumped/integration/foundation_impact.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331, mass = 0.0896;
const double stiffness = 4.0 / 3.0 * 10e6 / (1.0 - 0.16) * std::sqrt(radius);
const StandardLinearSphere solid{.stiffness = stiffness, .ratio = 1.0, .relaxation_time = 1e-3,
                                 .radius = radius};

TEST(RungE, PathsAndImpactsAtSixSpeeds) {
  test::expect_rows(verify_viscoelastic_contact(), 32);
}

TEST(FoundationTest, WithoutBranchIsHertz) {
  const StandardLinearSphere elastic{.stiffness = stiffness, .ratio = 0.0, .relaxation_time = 1.0,
                                     .radius = radius};
  const auto impact = foundation_impact(elastic, {.mass = mass, .speed = 1.0});
  const auto hertz = elastic_impact({.stiffness = stiffness, .damping = 0.0}, {mass, 1.0});
  EXPECT_NEAR(impact.restitution, 1.0, 3e-4);
  EXPECT_NEAR(impact.peak_force / hertz.peak_force, 1.0, 3e-4);
  EXPECT_NEAR(impact.contact_time / hertz.contact_time, 1.0, 2e-3);
}

// One internal state on the whole Hertz force is Lee–Radok while the contact
// grows: peak force and deflection are those of the table. It keeps memory of
// area that has let go, and so loses more while it shrinks: restitution 0.018 to
// 0.024 lower, contact 5 to 7 % shorter.
TEST(RungE, TheLawIsExactWhileTheContactGrows) {
  for (const auto& [v, e, t, f, h, h_end] : targets::viscoelastic_impacts) {
    LumpedProblem problem;
    problem.sphere = {.mass = mass, .diameter = 2.0 * radius};
    problem.impact = {.speed = v, .separation = SeparationRule::zero_force};
    problem.model.law = "standard-linear-solid";
    problem.model.parameters = {
        {"stiffness", stiffness}, {"ratio", 1.0}, {"relaxation_time", 1e-3}};
    const auto scalars = simulate(problem).scalars;
    EXPECT_NEAR(scalars.peak_force / f, 1.0, 1e-5) << v;
    EXPECT_NEAR(scalars.peak_deflection / h, 1.0, 1e-5) << v;
    EXPECT_GT(e - scalars.restitution, 0.017) << v;
    EXPECT_LT(e - scalars.restitution, 0.025) << v;
    EXPECT_NEAR(scalars.contact_time / t, 0.94, 0.015) << v;
  }
}

}  // namespace
}  // namespace rebound
