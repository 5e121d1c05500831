#include "comparisons/discrepancy/diagnosis/search/force_score_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

Dataset without_effects(std::int64_t seed) {
  return testing::measured_data(testing::experiment_with({}, seed));
}

AssessedFit assessed(const Dataset& dataset) {
  const Observations seen = observe({dataset});
  return judge_believed(seen, fit_hypothesis(seen, {.believed = testing::believed_law()}),
                        absent_effects({}), {}, 1);
}

// The less likely of two tests counts as twice its chance, so that a chance below one half comes
// up in at most half of the cases, and in nearly as many. Three deviations of 60 such cases
// are 11.6.
TEST(ForceScoreTest, OfNoiseItsChanceIsUniform) {
  int below_half = 0, below_twentieth = 0;
  for (int seed = 300; seed < 360; ++seed) {
    const Observations seen = observe({without_effects(seed)});
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
    const ScoreTest test = test_further_force(seen, fit, EffectSensitivities(seen, fit, {}),
                                              std::numeric_limits<double>::infinity());
    ASSERT_GT(test.freedom, 20);
    below_half += test.p_value < 0.5 ? 1 : 0;
    below_twentieth += test.p_value < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 27.0, 11.6);
  EXPECT_LE(below_twentieth, 8);  // 3 on average, and three deviations of that
}

/// Readings with a force beside them that the ball does not feel: a saw of the force, whose teeth
/// come at the same readings at every speed.
Dataset with_a_saw(Dataset dataset, double height) {
  for (auto& shot : dataset.shots) {
    auto& force = shot.trace.force;
    const auto top = std::max_element(force.begin(), force.end());
    constexpr double tooth = 2500.0;  // N
    const double noise = 6.0 * height;
    for (auto f = force.begin(); f < top; ++f)
      if (*f > noise) *f += height * (2.0 * (*f / tooth - std::floor(*f / tooth)) - 1.0);
  }
  return dataset;
}

TEST(ForceScoreTest, SeesWhatChiSquareDoesNot) {
  const AssessedFit fit = assessed(with_a_saw(without_effects(7), 9.0));
  EXPECT_GT(fit.p_value, 0.001);
  EXPECT_LT(fit.further_force.p_value, 1e-3);
  EXPECT_FALSE(fit.adequate);
  EXPECT_TRUE(assessed(without_effects(7)).adequate);
}

}  // namespace
}  // namespace rebound
