#include "comparisons/evaluation/drop_test/fem_drop.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

FemProblem ball() {
  FemProblem problem;
  problem.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3};
  problem.material = {.youngs_modulus = 5e6,
                      .poisson_ratio = 0.4,
                      .branches = {{.ratio = 0.3, .relaxation_time = 0.4e-3}}};
  return problem;
}

/// e = 0.55 + 0.2 ln(E/5 MPa) − 0.1 ln(g/0.3), instead of an impact.
FemResult closed_form(const FemProblem& problem) {
  FemResult result;
  result.scalars.restitution = 0.55 + 0.2 * std::log(problem.material.youngs_modulus / 5e6) -
                               0.1 * std::log(problem.material.branches[0].ratio / 0.3);
  return result;
}

TEST(FemDropTest, OneParameterPropagatesByItsSlope) {
  const DropOutcome outcome = drop_test(
      ball(),
      ParameterUncertainty{
          .names = {"Young's modulus"}, .standard_errors = {0.1 * 5e6}, .correlation = {{1.0}}},
      closed_form, {.confidence = 0.95});
  EXPECT_DOUBLE_EQ(outcome.restitution, 0.55);
  EXPECT_NEAR(outcome.interval->second - 0.55, 1.959964 * 0.2 * 0.1, 1e-6);
  EXPECT_NEAR(outcome.interval->first, 1.1 - outcome.interval->second, 1e-12);
  // 0.522 to 0.576 is −1.4 to 1.3 deviations.
  EXPECT_NEAR(*outcome.probability_inside, 0.9032 - 0.0808, 1e-3);
  EXPECT_EQ(outcome.verdict, DropVerdict::undecided);
}

TEST(FemDropTest, CorrelationCounts) {
  const auto width = [&](double correlation) {
    const auto outcome =
        drop_test(ball(),
                  ParameterUncertainty{.names = {"Young's modulus", "branch 1 ratio"},
                                       .standard_errors = {0.05 * 5e6, 0.1 * 0.3},
                                       .correlation = {{1.0, correlation}, {correlation, 1.0}}},
                  closed_form);
    return outcome.interval->second - outcome.interval->first;
  };
  EXPECT_NEAR(width(1.0), 0.0, 1e-6);  // 0.2 × 5 % less 0.1 × 10 %
  EXPECT_NEAR(width(0.0) / width(-1.0), std::sqrt(0.5), 1e-6);
}

TEST(FemDropTest, WithoutUncertaintyThereIsNoInterval) {
  const DropOutcome outcome = drop_test(ball(), std::nullopt, closed_form);
  EXPECT_FALSE(outcome.interval.has_value());
  EXPECT_EQ(outcome.notes.size(), 1u);
}

TEST(FemDropTest, AnImpactThatDoesNotEndIsAnError) {
  const FemRunner never = [](const FemProblem&) {
    FemResult result;
    result.incomplete_because = "the contact had not ended by the end time";
    return result;
  };
  EXPECT_EQ(testing::refusal_of([&] { drop_test(ball(), std::nullopt, never); }).code(),
            ExitCode::solver_failed);
}

}  // namespace
}  // namespace rebound
