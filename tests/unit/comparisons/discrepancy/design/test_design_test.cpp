// What a plan is said to find, against what experiments with that effect hidden in them show.
#include "comparisons/discrepancy/design/test_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/design/planned_data.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

const FindableEffect& of(const TestDesign& design, const std::string& name) {
  return *std::find_if(design.effects.begin(), design.effects.end(),
                       [&](const FindableEffect& one) { return one.name == name; });
}

/// Share of experiments with this effect in which the believed model is refused.
double share_with_a_gap(const SynthesisFile& plan, const EffectChoice& effect) {
  constexpr int experiments = 40;
  int gaps = 0;
  for (int seed = 1; seed <= experiments; ++seed) {
    SynthesisFile file = plan;
    file.seed = seed;
    file.effects = {effect};
    const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = file.lumped});
    if (!judge_believed(seen, fit, absent_effects({}), {}, 1).adequate) ++gaps;
  }
  return static_cast<double>(gaps) / experiments;
}

TEST(TestDesignTest, AGapIsSaidAsOftenAsPredicted) {
  const SynthesisFile plan = testing::experiment_with({}, 5);
  const TestDesign design = design_test(plan, 1);
  for (const char* name : {"strain-stiffening", "linear-dashpot"}) {
    const FindableEffect& effect = of(design, name);
    ASSERT_TRUE(effect.found) << name;
    const double null = find_effect(name).card.null;
    const double full = share_with_a_gap(plan, {name, null + *effect.found});
    const double third = share_with_a_gap(plan, {name, null + *effect.found / 3.0});
    RecordProperty(std::string(name) + "_full", std::to_string(full));
    EXPECT_NEAR(full, design_chance, 0.1) << name;
    EXPECT_LT(third, 0.35) << name;
  }
}

TEST(TestDesignTest, WhatIsAbsorbedIsToldApartFromNothing) {
  const TestDesign design = design_test(testing::experiment_with({}, 5), 1);
  // The scale of the force and the mass of the ball differ by nothing in histories of one ball.
  const FindableEffect& gain = of(design, "force-gain");
  EXPECT_GT(gain.cosine, 0.99);
  EXPECT_FALSE(gain.told_apart);
  for (const FindableEffect& one : design.effects)
    if (one.told_apart) {
      EXPECT_GE(*one.told_apart, *one.found) << one.name;
    }
}

// Beside a rival at a cosine c, what is left of χ² is 1 − c²: the size that is told apart goes with
// its root where the effect is linear.
TEST(TestDesignTest, ARivalCostsWhatTheCosineLeaves) {
  const TestDesign design = design_test(testing::experiment_with({}, 5), 1);
  const SelectionRules rules;
  constexpr double surplus = 1.2815515655446004;
  const double found = std::pow(std::sqrt(design.gap_threshold) + surplus, 2);
  const double apart = std::pow(surplus + std::sqrt(surplus * surplus + rules.close_criterion), 2);
  int compared = 0;
  for (const FindableEffect& one : design.effects) {
    if (!one.told_apart || one.cosine > 0.95) continue;
    const double rise = apart / (1.0 - one.cosine * one.cosine);
    if (rise < 1.2 * found) continue;
    EXPECT_NEAR(*one.told_apart / *one.found, std::sqrt(rise / found),
                0.2 * std::sqrt(rise / found))
        << one.name << " " << one.cosine;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST(TestDesignTest, HalfTheNoiseHalvesWhatOnlyNoiseHides) {
  SynthesisFile plan = testing::experiment_with({}, 5);
  plan.mass_uncertainty = 0.0;
  plan.instrument.force_gain_uncertainty = 1e-6;
  for (SynthesisShot& shot : plan.shots) shot.speed_uncertainty = 1e-6;
  const TestDesign design = design_test(plan, 1);
  const auto half = std::find_if(
      design.changes.begin(), design.changes.end(),
      [](const DesignChange& one) { return one.what == "half the noise of the force"; });
  ASSERT_NE(half, design.changes.end());
  EXPECT_NEAR(half->size_error_ratio, 0.5, 0.05);
}

TEST(TestDesignTest, RefusesWhatIsNoPlan) {
  SynthesisFile plan = testing::experiment_with({{"strain-stiffening", 0.5}}, 5);
  EXPECT_THROW(design_test(plan, 1), Error);
  plan = testing::experiment_with({}, 5);
  plan.tier = Tier::fem;
  EXPECT_THROW(design_test(plan, 1), Error);
  plan = testing::experiment_with({}, 5);
  plan.shots.resize(1);
  plan.shots[0].history = false;
  plan.shots[0].restitution_uncertainty = 0.01;
  EXPECT_THROW(design_test(plan, 1), Error);
}

}  // namespace
}  // namespace rebound
