#include "lumped/integration/force_deflection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

TEST(ForceDeflectionTest, FollowsTheImplicitRelation) {
  const HuntCrossley law{.stiffness = 3.5e6, .damping = 17.63e4, .power = Power(1.5)};
  const HuntCrossleyImpact exact(law, {.mass = 0.0896, .speed = 15.0});
  DeflectionPoints points;
  std::vector<double> expected;
  for (double v : {14.99, 14.0, 9.0, 3.0, 0.5, -0.5, -3.0, -6.0, -9.0, -9.9}) {
    points.deflection.push_back(exact.deflection(v));
    points.branch.push_back(v > 0.0 ? Branch::loading : Branch::unloading);
    expected.push_back(law.force(exact.deflection(v), v));
  }
  const auto forces = forces_at(test::typical_problem("hunt-crossley"), points);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_NEAR(forces[i], expected[i], 1e-7 * exact.peak_force()) << points.deflection[i];
}

// A trace's own deflections give back its forces, for every law and rule.
TEST(ForceDeflectionTest, GivesBackTheTrace) {
  for (const auto& card : all_laws())
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      LumpedProblem problem = test::typical_problem(card.name);
      problem.impact.separation = rule;
      const LumpedResult run = simulate_fast(problem);
      const auto forces = forces_at(problem, deflection_points(run.trace));
      const auto& x = run.trace.deflection;
      for (std::size_t i = 0; i < forces.size(); ++i) {
        // Rounding of x counts as its root near the turning point.
        const bool tip = x[i] > 0.9999 * run.scalars.peak_deflection;
        EXPECT_NEAR(forces[i], run.trace.force[i],
                    (tip ? 3e-3 : 2e-7) * run.scalars.peak_force)
            << card.name << " sample " << i;
      }
    }
}

TEST(ForceDeflectionTest, IsContinuousBeyondItsEnds) {
  const LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
  const LumpedResult run = simulate_fast(problem);
  const double peak = run.scalars.peak_deflection, left = run.trace.deflection.back();
  ASSERT_GT(left, 0.0);  // under zero force a damped spring leaves early
  const auto forces = forces_at(problem, {{1.1 * peak, 1.1 * peak, 0.5 * left, -1e-3},
                                          {Branch::loading, Branch::unloading, Branch::unloading,
                                           Branch::loading}});
  EXPECT_NEAR(forces[0], 2.5e5 * peak, 1e-5 * forces[0]);  // κ x at rest
  EXPECT_EQ(forces[0], forces[1]);
  EXPECT_NEAR(forces[2], 0.0, 1e-6);
  EXPECT_NEAR(forces[3], 60.0 * 15.0, 1e-9);  // λ v₀ at first touch
}

}  // namespace
}  // namespace rebound
