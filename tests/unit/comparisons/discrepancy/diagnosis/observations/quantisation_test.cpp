#include "comparisons/discrepancy/diagnosis/observations/quantisation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

Dataset rounded_to(double step, std::int64_t seed) {
  const SynthesisFile file = testing::experiment_with({}, seed);
  Dataset dataset = synthesize(file, simulator_of(file, {})).dataset;
  for (MeasuredImpact& shot : dataset.shots)
    for (double& force : shot.trace.force) force = step * std::round(force / step);
  return dataset;
}

TEST(QuantisationTest, NoiseHasNoStep) {
  const SynthesisFile file = testing::experiment_with({}, 1);
  for (const MeasuredImpact& shot : synthesize(file, simulator_of(file, {})).dataset.shots)
    EXPECT_EQ(quantisation_step(shot.trace.force), 0.0);
}

TEST(QuantisationTest, FindsTheStepOfARecorder) {
  for (const MeasuredImpact& shot : rounded_to(35.0, 1).shots)
    EXPECT_NEAR(quantisation_step(shot.trace.force), 35.0, 1e-6);
}

/// As files print them: two neighbours among large readings say the step to fewer places.
TEST(QuantisationTest, FindsTheStepInReadingsOfSevenDigits) {
  constexpr double step = 24.1316787;
  std::vector<double> printed;
  printed.reserve(500);
  for (int k = 0; k < 400; ++k)
    printed.push_back(
        std::stod(fmt::format("{:.7g}", step * std::round(200.0 * std::sin(0.01 * k)))));
  printed.insert(printed.end(), 100, 0.0);
  EXPECT_NEAR(quantisation_step(printed), step, 1e-4);
}

TEST(QuantisationTest, RoundingIsNoiseOfItsOwnAndSaid) {
  const Observations seen = observe({rounded_to(35.0, 1)});
  EXPECT_NEAR(seen.shots[0].noise.deviation, std::hypot(20.0, 35.0 / std::sqrt(12.0)), 1e-6);
  ASSERT_FALSE(seen.warnings.empty());
  EXPECT_NE(seen.warnings[0].find("steps of 35 N"), std::string::npos);
}

TEST(QuantisationTest, AQuietThatIsRoundedAwayLeavesTheRounding) {
  Dataset dataset = rounded_to(500.0, 1);
  dataset.instrument.force_noise.reset();
  const Observations seen = observe({dataset});
  ASSERT_TRUE(seen.missing.empty());
  EXPECT_NEAR(seen.shots[0].noise.deviation, 0.5 * 500.0, 1e-6);
}

TEST(QuantisationTest, ManyDigitsAreNoStep) {
  EXPECT_EQ(observe({rounded_to(0.1, 1)}).shots[0].noise.deviation, 20.0);
}

// Rounded by more than the noise: nothing but the recorder is to blame.
TEST(QuantisationTest, ARoundedNullLacksNothingOfThePhysics) {
  int gaps = 0;
  for (int seed = 1; seed <= 5; ++seed) {
    DiagnosisRequest request;
    request.datasets = {rounded_to(100.0, seed)};
    request.believed = testing::believed_law();
    request.ask_fem = false;
    const Diagnosis d = diagnose(request);
    if (d.candidates != std::vector<std::vector<std::string>>{{"quantisation"}}) ++gaps;
  }
  EXPECT_LE(gaps, 1);
}

}  // namespace
}  // namespace rebound
