#include "comparisons/evaluation/drop_test/drop_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/evaluation/drop_test/model_at_speed.hpp"
#include "comparisons/evaluation/drop_test/stored_calibration.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

TEST(RegulationTest, SpeedOfTheDrop) {
  EXPECT_NEAR(drop_speed(1.8), 5.94171, 5e-6);
}

TEST(DropTest, IsTheModelsOwnRestitution) {
  LumpedProblem problem = test::typical_problem("kuwabara-kono");
  const DropOutcome outcome = drop_test(problem, std::nullopt);
  problem.impact.speed = drop_speed(1.8);
  EXPECT_EQ(outcome.restitution, simulate_fast(problem).scalars.restitution);
  EXPECT_FALSE(outcome.interval.has_value());
  EXPECT_EQ(outcome.notes.size(), 1u);
}

TEST(DropTest, SmallErrorsPropagateLinearly) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters["damping"] = 40e4;
  // Fully correlated errors of equal share leave p = λ v/κ, and so e, alone.
  const double k = problem.model.parameters["stiffness"], l = problem.model.parameters["damping"];
  const auto at = [&](double correlation) {
    return drop_test(problem,
                     ParameterUncertainty{.names = {"stiffness", "damping"},
                                          .standard_errors = {0.01 * k, 0.01 * l},
                                          .correlation = {{1.0, correlation}, {correlation, 1.0}}},
                     {.draws = 4000});
  };
  const auto together = at(1.0);
  EXPECT_NEAR(together.interval->second - together.interval->first, 0.0, 1e-7);
  const auto apart = at(0.0);
  EXPECT_EQ(at(0.0).interval, apart.interval);  // seeded
  problem.impact.speed = drop_speed(1.8);
  const double e = simulate_fast(problem).scalars.restitution;
  problem.model.parameters["damping"] = 1.01 * l;
  const double slope = e - simulate_fast(problem).scalars.restitution;  // per 1 % of p
  const double expected = 2.0 * 1.959964 * std::sqrt(2.0) * slope;
  EXPECT_NEAR((apart.interval->second - apart.interval->first) / expected, 1.0, 0.06);
}

TEST(DropTest, Verdicts) {
  EXPECT_EQ(verdict_of(0.55, std::pair(0.53, 0.57)), DropVerdict::inside);
  EXPECT_EQ(verdict_of(0.55, std::pair(0.51, 0.57)), DropVerdict::undecided);
  EXPECT_EQ(verdict_of(0.50, std::pair(0.48, 0.52)), DropVerdict::below);
  EXPECT_EQ(verdict_of(0.60, std::nullopt), DropVerdict::above);
  EXPECT_EQ(verdict_of(0.522, std::nullopt), DropVerdict::inside);
}

// The paper's per-speed λ of core A: between 5 and 15 m/s lies the drop.
TEST(DropTest, PerSpeedParametersAreTakenFromBothSides) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}};
  problem.model.at_speed = {{15.0, {{"damping", 17.63e4}}}, {5.0, {{"damping", 37.69e4}}}};
  problem.impact.speed = drop_speed(1.8);
  const ModelAtSpeed at = model_at_speed(problem);
  const double share = std::log(problem.impact.speed / 5.0) / std::log(3.0);
  EXPECT_NEAR(at.model.parameters.at("damping"), 37.69e4 + share * (17.63e4 - 37.69e4), 1e-6);
  const DropOutcome outcome = drop_test(problem, std::nullopt);
  ASSERT_TRUE(outcome.interval.has_value());
  EXPECT_LT(outcome.interval->first, outcome.restitution);
  EXPECT_GT(outcome.interval->second, outcome.restitution);
  problem.impact.speed = 30.0;
  EXPECT_EQ(model_at_speed(problem).model.parameters.at("damping"), 17.63e4);
}

TEST(DropTest, Refusals) {
  const LumpedProblem problem = test::typical_problem("hunt-crossley");
  EXPECT_THROW(drop_test(problem, std::nullopt, {.height = -1.0}), Error);
  EXPECT_THROW(drop_test(problem, std::nullopt, {.confidence = 1.0}), Error);
  EXPECT_THROW(drop_test(problem, ParameterUncertainty{.names = {"colour"},
                                                       .standard_errors = {1.0},
                                                       .correlation = {{1.0}}}),
               Error);
  EXPECT_THROW(drop_test(problem,
                         ParameterUncertainty{
                             .names = {"damping"}, .standard_errors = {1.0}, .correlation = {}}),
               Error);
  try {  // far beyond positive damping: most draws have no meaning
    drop_test(problem, ParameterUncertainty{
                           .names = {"damping"}, .standard_errors = {1e6}, .correlation = {{1.0}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::solver_failed);
  }
}

TEST(StoredCalibrationTest, DamagedIsCorrupt) {
  testing::TemporaryFolder folder;
  for (const char* text : {"{", "[]", "{\"estimates\": []}", "{\"model_toml\": \"law\"}"}) {
    folder.write("calibration.json", text);
    try {
      read_stored_calibration(folder.path() / "calibration.json");
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::corrupt_store) << text;
    }
  }
}

}  // namespace
}  // namespace rebound
