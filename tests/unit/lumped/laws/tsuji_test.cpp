#include "lumped/laws/tsuji.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/simulate.hpp"
#include "lumped/laws/exact_restitution.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

// α that returns e: published closed form at zero deflection, independent
// integration at zero force.
TEST(TsujiTest, DampingNumberOfATable) {
  const double table[][3] = {{0.9, 0.07495, 0.07662},
                             {0.7, 0.25225, 0.27328},
                             {0.5, 0.48177, 0.57081},
                             {0.3, 0.80019, 1.11186}};
  for (const auto& [e, at_deflection, at_force] : table)
    for (const auto rule : {SeparationRule::zero_deflection, SeparationRule::zero_force}) {
      const double damping = Tsuji::damping_for({.formula = "exact",
                                                 .restitution = e,
                                                 .mass = 0.09,
                                                 .impact = {.speed = 5.0, .separation = rule},
                                                 .parameters = {{"stiffness", 2e6}}});
      EXPECT_NEAR(damping / std::sqrt(0.09 * 2e6),
                  rule == SeparationRule::zero_force ? at_force : at_deflection, 2e-5);
    }
}

TEST(TsujiTest, RestitutionIsThatOfKelvinVoigt) {
  for (const auto rule : {SeparationRule::zero_deflection, SeparationRule::zero_force})
    for (double alpha : {0.1, 0.6, 1.5})
      for (double speed : {0.2, 20.0}) {
        LumpedProblem problem = test::typical_problem("tsuji");
        problem.impact = {.speed = speed, .separation = rule};
        problem.model.parameters["damping"] =
            alpha * std::sqrt(problem.sphere.mass * problem.model.parameters.at("stiffness"));
        EXPECT_NEAR(simulate_fast(problem).scalars.restitution,
                    kelvin_voigt_restitution(alpha / std::sqrt(5.0), rule), 1e-7);
      }
}

}  // namespace
}  // namespace rebound
