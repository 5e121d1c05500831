#include "comparisons/discrepancy/diagnosis/search/force_score_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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

// The least likely of three tests counts as three times its chance, and of ripples as many times as
// there are, some of which are nearly alike: a chance below one half comes up in fewer than half of
// the cases. Three deviations of 60 such cases are 11.6.
TEST(ForceScoreTest, OfNoiseItsChanceIsUniform) {
  int below_half = 0, below_twentieth = 0;
  for (int seed = 300; seed < 360; ++seed) {
    const Observations seen = observe({without_effects(seed)});
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = testing::believed_law()});
    const ScoreTest test =
        test_further_force(seen, fit, EffectSensitivities(seen, fit, {}), known_noise);
    ASSERT_GT(test.freedom, 1);
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

/// Readings with a ripple beside them that the ball does not feel: the same over the deflection at
/// every speed, while loading.
Dataset with_a_ripple(Dataset dataset, double cycles, double height) {
  double deepest = 0.0;
  const auto deflection = [](double force) { return std::pow(std::max(0.0, force), 2.0 / 3.0); };
  for (const auto& shot : dataset.shots)
    for (const double force : shot.trace.force) deepest = std::max(deepest, deflection(force));
  for (auto& shot : dataset.shots) {
    auto& force = shot.trace.force;
    const auto top = std::max_element(force.begin(), force.end());
    for (auto f = force.begin(); f < top; ++f) {
      const double x = deflection(*f) / deepest;
      *f += height * x * std::sin(2.0 * std::numbers::pi * cycles * x);
    }
  }
  return dataset;
}

TEST(ForceScoreTest, SeesARippleThatStraightLinesDoNotFollow) {
  const AssessedFit fit = assessed(with_a_ripple(without_effects(7), 11.0, 22.0));
  EXPECT_GT(fit.p_value, 0.001);
  EXPECT_EQ(fit.further_force.freedom, 2);
  EXPECT_LT(fit.further_force.p_value, 1e-3);
  EXPECT_FALSE(fit.adequate);
}

// Noise could make what is left of the ripple once in a hundred data sets, and an effect that takes
// nothing of it is adequate where nothing showed; it is none where the ripple showed the gap.
TEST(ForceScoreTest, ACandidateThatLeavesWhatShowedTheGapIsNone) {
  const Observations seen = observe({with_a_ripple(without_effects(7), 11.0, 16.0)});
  AssessedFit believed = judge_believed(
      seen, fit_hypothesis(seen, {.believed = testing::believed_law()}), absent_effects({}), {}, 1);
  const auto judged = [&] {
    AssessedFit candidate = judge_by_chi_square(
        seen, fit_extended(seen, believed.fit, {{"relaxation", 0.01, {}}}, SearchEffort::whole),
        {});
    judge_candidate(seen, absent_effects({}), {}, 1, believed, candidate);
    return candidate;
  };
  believed.further_force = believed.varying = {};
  EXPECT_TRUE(judged().adequate);
  EXPECT_LT(judged().further_force.p_value, 0.1);
  believed.further_force = {.chi_square = 25.0, .freedom = 2, .p_value = 5e-4};
  EXPECT_FALSE(judged().adequate);
}

// What an effect takes of it by chance is no explanation.
TEST(ForceScoreTest, AWeakRippleIsUnexplained) {
  int unexplained = 0;
  for (int seed = 31; seed < 35; ++seed) {
    const Diagnosis d = testing::diagnosis_of(with_a_ripple(without_effects(seed), 5.5, 28.0));
    unexplained += d.verdict == DiagnosisVerdict::unexplained ? 1 : 0;
    EXPECT_NE(d.verdict, DiagnosisVerdict::missing) << "seed " << seed;
  }
  EXPECT_GE(unexplained, 3);
}

}  // namespace
}  // namespace rebound
