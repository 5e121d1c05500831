#include "comparisons/discrepancy/diagnosis/search/varying_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

ScoreTest tested(const Dataset& dataset) {
  const Observations seen = observe({dataset});
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
  return test_varying_numbers(seen, fit, EffectSensitivities(seen, fit, {}), known_noise);
}

// As of ForceScoreTest: a chance below one half comes up in nearly half of the cases, and three
// deviations of forty are 9.5.
TEST(VaryingNumbersTest, OfNoiseItsChanceIsUniform) {
  int below_half = 0, below_twentieth = 0;
  for (int seed = 400; seed < 440; ++seed) {
    const ScoreTest test =
        tested(testing::measured_data(testing::three_times_each_speed({}, seed)));
    ASSERT_GT(test.freedom, 1);
    below_half += test.p_value < 0.5 ? 1 : 0;
    below_twentieth += test.p_value < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 18.0, 9.5);
  EXPECT_LE(below_twentieth, 6);  // 2 on average, and three deviations of that
}

/// Forces and times of the shots at one speed as another stiffness would have them.
Dataset with_another_stiffness_at(double speed, double by, Dataset dataset) {
  const double factor = std::pow(1.0 + by, 0.4);
  for (auto& shot : dataset.shots) {
    if (std::abs(shot.impact.speed - speed) > 1.0) continue;
    for (double& force : shot.trace.force) force *= factor;
    for (double& time : shot.trace.time) time /= factor;
  }
  return dataset;
}

TEST(VaryingNumbersTest, SeesAStiffnessOfOneSpeed) {
  const Dataset honest = testing::measured_data(testing::three_times_each_speed({}, 11));
  const Dataset stiffer = with_another_stiffness_at(15.0, 0.01, honest);
  const Observations seen = observe({stiffer});
  const AssessedFit fit = judge_believed(
      seen, fit_hypothesis(seen, {.believed = testing::believed_law()}), absent_effects({}), {}, 1);
  EXPECT_GT(fit.p_value, 0.001);
  EXPECT_LT(fit.varying.p_value, 1e-3);
  EXPECT_FALSE(fit.adequate);
  EXPECT_GT(tested(honest).p_value, 1e-2);
}

}  // namespace
}  // namespace rebound
