// What a plan is said to find, against what experiments with that effect hidden in them show.
#include "comparisons/discrepancy/design/test_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/design/planned_data.hpp"
#include "comparisons/discrepancy/design/refitted_change.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

const FindableEffect& of(const TestDesign& design, const std::string& name) {
  return *std::find_if(design.effects.begin(), design.effects.end(),
                       [&](const FindableEffect& one) { return one.name == name; });
}

TEST(TestDesignTest, WhatIsAbsorbedIsToldApartFromNothing) {
  const TestDesign design = design_test(testing::coarse_experiment(5), 1);
  // The scale of the force and the mass of the ball differ by nothing in histories of one ball.
  const FindableEffect& gain = of(design, "force-gain");
  EXPECT_GT(gain.cosine, 0.99);
  EXPECT_FALSE(gain.told_apart);
  for (const FindableEffect& one : design.effects)
    if (one.told_apart) {
      EXPECT_GE(*one.told_apart, *one.found()) << one.name;
    }
}

// Beside a rival at a cosine c, what is left of χ² is 1 − c²: the size that is told apart raises χ²
// by so much more, and no smaller one does. It may raise it by more than that where readings come
// and go with the size, as with a shift of the trigger.
TEST(TestDesignTest, ARivalCostsWhatTheCosineLeaves) {
  const SynthesisFile plan = testing::coarse_experiment(5);
  const TestDesign design = design_test(plan, 1);
  const PlannedData data = planned_data(plan);
  const RefittedChange refitted(data);
  const SelectionRules rules;
  constexpr double surplus = 1.2815515655446004;
  const double apart = std::pow(surplus + std::sqrt(surplus * surplus + rules.close_criterion), 2);
  int compared = 0;
  for (const FindableEffect& one : design.effects) {
    if (!one.told_apart || *one.told_apart < 1.05 * *one.found()) continue;
    const auto share_at = [&](double size) {
      EffectChoice hidden = one.sizes.back().hidden;
      const double null = find_effect(one.name).card.null;
      hidden.size = null + std::copysign(size, hidden.size - null);
      const double left = 1.0 - one.cosine * one.cosine;
      return refitted.rise(hidden).value_or(std::nan("")) * left / apart;
    };
    EXPECT_GE(share_at(*one.told_apart), 0.99) << one.name;
    EXPECT_LT(share_at(0.98 * *one.told_apart), 1.0) << one.name;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST(TestDesignTest, ChancesGrowWithTheSize) {
  const TestDesign design = design_test(testing::coarse_experiment(5), 1);
  EXPECT_LT(design.nothing_hidden.gap, 0.05);
  const FindableEffect& effect = of(design, "relaxation");
  ASSERT_EQ(effect.sizes.size(), design_chances.size());
  for (std::size_t i = 1; i < effect.chances.size(); ++i) {
    EXPECT_GT(effect.chances[i].size, effect.chances[i - 1].size);
    EXPECT_GE(effect.chances[i].gap, effect.chances[i - 1].gap);
  }
  for (const SizeOfChance& one : effect.sizes) EXPECT_LE(one.named, one.gap);
  EXPECT_LT(*effect.found_with(0.5), *effect.found());
}

TEST(TestDesignTest, HalfTheNoiseHalvesWhatOnlyNoiseHides) {
  SynthesisFile plan = testing::coarse_experiment(5);
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
  plan = testing::coarse_experiment(5);
  plan.shots.resize(1);
  plan.shots[0].history = false;
  plan.shots[0].restitution_uncertainty = 0.01;
  EXPECT_THROW(design_test(plan, 1), Error);
}

TEST(TestDesignTest, RepeatedScalarsAlone) {
  SynthesisFile plan = testing::coarse_experiment(5);
  for (SynthesisShot& shot : plan.shots) {
    shot.history = false;
    shot.repeats = 4;
    shot.restitution_uncertainty = 0.01;
    shot.contact_time_uncertainty = 2e-5;
  }
  const TestDesign design = design_test(plan, 1);
  EXPECT_EQ(design.shots, 12);
  EXPECT_FALSE(design.effects.empty());
  for (const DesignChange& one : design.changes)  // no record, no force, no deflection
    EXPECT_EQ(one.what.find("force"), std::string::npos) << one.what;
}

}  // namespace
}  // namespace rebound
