#include "comparisons/evaluation/convert/matched_law.hpp"

#include <gtest/gtest.h>

#include "comparisons/evaluation/convert/target_conventions.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

// From parameters far off, back to those of the law whose impact is wanted.
TEST(MatchedLawTest, RecoversEveryConvention) {
  for (const auto& target : target_conventions())
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      LumpedProblem problem = test::typical_problem(target.law);
      problem.impact.separation = rule;
      const auto truth = problem.model.parameters;
      const auto scalars = simulate_fast(problem).scalars;
      problem.model.parameters["stiffness"] *= 3.0;
      problem.model.parameters[target.loss_parameter] *= 0.4;
      const LumpedModel found = matched_law({.start = problem,
                                             .loss_parameter = target.loss_parameter,
                                             .wanted = {.restitution = scalars.restitution,
                                                        .contact_time = scalars.contact_time,
                                                        .peak_force = {}}});
      for (const auto& name : {std::string("stiffness"), target.loss_parameter})
        EXPECT_NEAR(found.parameters.at(name) / truth.at(name), 1.0, 1e-6) << target.name << name;
    }
}

TEST(MatchedLawTest, SaysWhatIsOutOfReach) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  try {
    matched_law({.start = problem,
                 .loss_parameter = "damping",
                 .wanted = {.restitution = 1e-9, .contact_time = {}, .peak_force = {}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::solver_failed);
  }
}

}  // namespace
}  // namespace rebound
