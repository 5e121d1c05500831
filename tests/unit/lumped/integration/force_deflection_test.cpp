#include "lumped/integration/force_deflection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/integration/sensitivity_names.hpp"
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
        EXPECT_NEAR(forces[i], run.trace.force[i], (tip ? 3e-3 : 2e-7) * run.scalars.peak_force)
            << card.name << " sample " << i;
      }
    }
}

TEST(ForceDeflectionTest, SlopesAreThoseOfTheForces) {
  for (const auto& card : all_laws())
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      if (has_branch(card.name)) continue;
      LumpedProblem problem = test::typical_problem(card.name);
      problem.impact.separation = rule;
      problem.controls.relative_tolerance = 1e-11;
      // Away from a corner of the table of coefficients.
      if (problem.model.parameters.contains("poisson_ratio"))
        problem.model.parameters["poisson_ratio"] = 0.37;
      const LumpedResult run = simulate_fast(problem);
      DeflectionPoints points;
      // Not the tip, where the curve is vertical, nor beyond an end that moves.
      const double least = 1.1 * run.trace.deflection.back() + 1e-5;
      for (const auto branch : {Branch::loading, Branch::unloading})
        for (double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97})
          if (share * run.scalars.peak_deflection > least) {
            points.deflection.push_back(share * run.scalars.peak_deflection);
            points.branch.push_back(branch);
          }
      const auto by = all_directions(card.name);
      const ForcesWithSensitivities found = forces_with_sensitivities_at(problem, points, by);
      const auto plain = forces_at(problem, points);
      const auto names = names_of_directions(card.name);
      for (std::size_t j = 0; j < by.size(); ++j) {
        const auto forces_with = [&](double factor) {
          LumpedProblem changed = problem;
          double& value = names[j] == "mass"    ? changed.sphere.mass
                          : names[j] == "speed" ? changed.impact.speed
                                                : changed.model.parameters.at(names[j]);
          value *= factor;
          return forces_at(changed, points);
        };
        const double value = names[j] == "mass"    ? problem.sphere.mass
                             : names[j] == "speed" ? problem.impact.speed
                                                   : problem.model.parameters.at(names[j]);
        const double h = 1e-4;
        const auto a = forces_with(1 + h), b = forces_with(1 - h), c = forces_with(1 + 2 * h),
                   d = forces_with(1 - 2 * h);
        for (std::size_t i = 0; i < plain.size(); ++i) {
          const double expected = (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h);
          EXPECT_NEAR(found.slopes[i * by.size() + j] * value, expected,
                      1e-6 * run.scalars.peak_force)
              << card.name << " by " << names[j] << " at point " << i;
        }
      }
      for (std::size_t i = 0; i < plain.size(); ++i)
        EXPECT_NEAR(found.force[i], plain[i], 1e-9 * run.scalars.peak_force);
    }
}

TEST(ForceDeflectionTest, IsContinuousBeyondItsEnds) {
  const LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
  const LumpedResult run = simulate_fast(problem);
  const double peak = run.scalars.peak_deflection, left = run.trace.deflection.back();
  ASSERT_GT(left, 0.0);  // under zero force a damped spring leaves early
  const auto forces = forces_at(
      problem, {{1.1 * peak, 1.1 * peak, 0.5 * left, -1e-3},
                {Branch::loading, Branch::unloading, Branch::unloading, Branch::loading}});
  EXPECT_NEAR(forces[0], 2.5e5 * peak, 1e-5 * forces[0]);  // κ x at rest
  EXPECT_EQ(forces[0], forces[1]);
  EXPECT_NEAR(forces[2], 0.0, 1e-6);
  EXPECT_NEAR(forces[3], 60.0 * 15.0, 1e-9);  // λ v₀ at first touch
}

}  // namespace
}  // namespace rebound
