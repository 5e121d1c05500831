#include "lumped/integration/force_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/sensitivities.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

TEST(ForceTimeTest, GivesBackTheTrace) {
  for (const auto& card : all_laws()) {
    const LumpedProblem problem = test::typical_problem(card.name);
    const LumpedResult run = simulate_fast(problem);
    std::vector<double> instants = run.trace.time;
    std::reverse(instants.begin(), instants.end());  // in any order
    const TimedForces found = forces_at_instants(problem, instants);
    for (std::size_t i = 0; i < instants.size(); ++i)
      ASSERT_NEAR(found.force[i], run.trace.force[instants.size() - 1 - i],
                  3e-8 * run.scalars.peak_force)
          << card.name << " at " << instants[i];
    const std::vector<double> outside = {-1e-9, 1.000001 * run.scalars.contact_time};
    for (double force : forces_at_instants(problem, outside).force) EXPECT_EQ(force, 0.0);
  }
}

TEST(ForceTimeTest, SlopesAreThoseOfTheForces) {
  for (const auto& card : all_laws()) {
    if (has_branch(card.name)) continue;
    LumpedProblem problem = test::typical_problem(card.name);
    problem.controls.relative_tolerance = 1e-11;
    // Away from a corner of the table of coefficients.
    if (problem.model.parameters.contains("poisson_ratio"))
      problem.model.parameters["poisson_ratio"] = 0.37;
    const LumpedResult run = simulate_fast(problem);
    std::vector<double> instants;
    for (double share : {0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97})
      instants.push_back(share * run.scalars.contact_time);
    const auto by = all_directions(card.name);
    const auto names = names_of_directions(card.name);
    const TimedForces found = forces_at_instants(problem, instants, by);
    constexpr double h = 1e-4;
    for (std::size_t j = 0; j < by.size(); ++j) {
      double value = 0.0;
      const auto forces_with = [&](double factor) {
        LumpedProblem changed = problem;
        double& at = names[j] == "mass"    ? changed.sphere.mass
                     : names[j] == "speed" ? changed.impact.speed
                                           : changed.model.parameters.at(names[j]);
        value = at;
        at *= factor;
        return forces_at_instants(changed, instants).force;
      };
      const auto a = forces_with(1 + h), b = forces_with(1 - h), c = forces_with(1 + 2 * h),
                 d = forces_with(1 - 2 * h);
      for (std::size_t i = 0; i < instants.size(); ++i)
        EXPECT_NEAR(found.slopes[i * by.size() + j] * value,
                    (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h),
                    1e-6 * run.scalars.peak_force)
            << card.name << " by " << names[j] << " at instant " << i;
    }
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const double step = 1e-4 * run.scalars.contact_time;
      const auto f =
          forces_at_instants(problem, std::vector<double>{instants[i] + step, instants[i] - step});
      EXPECT_NEAR(found.rate[i] * run.scalars.contact_time,
                  (f.force[0] - f.force[1]) / (2.0 * step) * run.scalars.contact_time,
                  1e-4 * run.scalars.peak_force);
    }
  }
}

}  // namespace
}  // namespace rebound
