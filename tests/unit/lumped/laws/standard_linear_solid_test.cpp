#include "lumped/laws/standard_linear_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/sensitivities.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/mechanism_cases.hpp"

namespace rebound {
namespace {

LumpedProblem solid_with(double ratio, double relaxation_time) {
  LumpedProblem problem = test::typical_problem("standard-linear-solid");
  problem.model.parameters = {
      {"stiffness", 3.5e6}, {"ratio", ratio}, {"relaxation_time", relaxation_time}};
  return problem;
}

void expect_hertz(const LumpedProblem& problem, double stiffness, double tolerance) {
  const auto exact = test::hertz(stiffness, problem.sphere.mass, problem.impact.speed);
  for (auto run : {simulate, simulate_fast}) {
    const auto found = run(problem).scalars;
    EXPECT_NEAR(found.restitution, 1.0, tolerance);
    EXPECT_NEAR(found.contact_time / exact.contact_time, 1.0, tolerance);
    EXPECT_NEAR(found.peak_deflection / exact.peak_deflection, 1.0, tolerance);
  }
}

TEST(StandardLinearSolidTest, NoBranchIsHertz) {
  expect_hertz(solid_with(0.0, 1e-3), 3.5e6, 1e-5);
}

TEST(StandardLinearSolidTest, SlowBranchIsStiffer) {
  expect_hertz(solid_with(1.0, 1e4), 7e6, 1e-5);
}

// The law is Hertz with the relaxing branch that can be put beside any law.
TEST(StandardLinearSolidTest, IsHertzWithABranchBesideIt) {
  const LumpedProblem beside = test::with(test::elastic_problem(), [](Mechanisms& m) {
    m.relaxation = {.ratio = 0.8, .relaxation_time = 7e-4};
  });
  test::expect_same_impact(solid_with(0.8, 7e-4), beside, 1e-8);
}

// A further branch acts beside the law's own: two equal ones are one of twice the ratio.
TEST(StandardLinearSolidTest, TakesAFurtherBranch) {
  const LumpedProblem two = test::with(solid_with(0.4, 7e-4), [](Mechanisms& m) {
    m.relaxation = {.ratio = 0.4, .relaxation_time = 7e-4};
  });
  test::expect_same_impact(two, solid_with(0.8, 7e-4), 1e-8);
}

TEST(StandardLinearSolidTest, HasNoSensitivities) {
  for (auto run : {sensitivities, sensitivities_fast})
    EXPECT_THROW(run(solid_with(0.8, 7e-4)), Error);
}

}  // namespace
}  // namespace rebound
