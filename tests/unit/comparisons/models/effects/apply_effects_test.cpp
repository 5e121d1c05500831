// What apply_effects refuses, and what it passes over.
#include <gtest/gtest.h>

#include "comparisons/models/effects/effect.hpp"
#include "tests/support/effect_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

TEST(ApplyEffectsTest, UnknownNamesTheKnown) {
  LumpedProblem problem = test::problem_for_effects();
  const Error error = refusal_of([&] { apply_effects({{"friction", 0.1, {}}}, problem); });
  EXPECT_NE(error.location().allowed.find("plate-friction"), std::string::npos);
}

TEST(ApplyEffectsTest, OnceIsEnough) {
  LumpedProblem problem = test::problem_for_effects();
  const Error error = refusal_of([&] {
    apply_effects({{"permanent-set", 0.05, {}}, {"permanent-set", 0.02, {}}}, problem);
  });
  EXPECT_EQ(error.location().key, "model.effect[1].name");
}

TEST(ApplyEffectsTest, AFaultOfTheMeasurementIsSentToSynthesize) {
  LumpedProblem problem = test::problem_for_effects();
  const Error error = refusal_of([&] { apply_effects({{"force-gain", 0.03, {}}}, problem); });
  EXPECT_NE(std::string(error.what()).find("synthesize"), std::string::npos);
}

TEST(ApplyEffectsTest, FrictionHasNoLumpedForm) {
  LumpedProblem problem = test::problem_for_effects();
  const Error error = refusal_of([&] { apply_effects({{"plate-friction", 0.3, {}}}, problem); });
  EXPECT_NE(std::string(error.what()).find("no form in the lumped tier"), std::string::npos);
}

TEST(ApplyEffectsTest, TheFormulaEffectNeedsAFormula) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  EXPECT_NE(std::string(refusal_of([&] {
                          apply_effects({{"low-loss-damping-formula", 1.0, {}}}, problem);
                        }).what())
                .find("restitution"),
            std::string::npos);
}

TEST(ApplyEffectsTest, APlateThatMovesTakesNoSecondSpring) {
  LumpedProblem problem = test::problem_for_effects();
  problem.model.mechanisms.plate.stiffness = 5e7;
  EXPECT_EQ(refusal_of([&] {
              apply_effects({{"plate-compliance", 2e-8, {}}}, problem);
            })
                .location()
                .key,
            "model.effect[0].name");
}

TEST(ApplyEffectsTest, TheMeasurementPassesOverWhatIsPhysical) {
  MeasurementChain chain;
  const std::vector<EffectChoice> effects = {{"permanent-set", 0.05, {}}, {"force-gain", 0.03, {}}};
  apply_effects(effects, chain);
  EXPECT_EQ(chain.force_gain, 0.03);
  ASSERT_EQ(physical_effects(effects).size(), 1u);
  EXPECT_EQ(physical_effects(effects)[0].name, "permanent-set");
}

TEST(ApplyEffectsTest, AFaultOfOneShotActsThereAlone) {
  const std::vector<EffectChoice> effects = {{"shot-gain", 0.1, {{"shot", 2.0}}},
                                             {"shot-speed", 0.2, {{"shot", 3.0}}}};
  MeasurementChain none, first{.shot = 1}, second{.shot = 2}, third{.shot = 3};
  for (MeasurementChain* chain : {&none, &first, &second, &third}) apply_effects(effects, *chain);
  EXPECT_EQ(none, MeasurementChain{});
  EXPECT_EQ(first, MeasurementChain{.shot = 1});
  EXPECT_EQ(second, (MeasurementChain{.force_gain = 0.1, .shot = 2}));
  EXPECT_EQ(third, (MeasurementChain{.speed_error = 0.2, .shot = 3}));
}

TEST(ApplyEffectsTest, AFaultOfOneShotAddsToThatOfAll) {
  MeasurementChain one{.shot = 1}, other{.shot = 1};
  apply_effects({{"shot-gain", 0.25, {}}, {"force-gain", 0.5, {}}}, one);
  apply_effects({{"force-gain", 0.5, {}}, {"shot-gain", 0.25, {}}}, other);
  EXPECT_EQ(one.force_gain, 0.75);
  EXPECT_EQ(one, other);
}

TEST(ApplyEffectsTest, CompliancesAreReciprocals) {
  FemProblem problem = test::fem_problem_for_effects();
  apply_effects({{"plate-compliance", 2e-8, {{"mass", 3.0}}}}, problem);
  EXPECT_DOUBLE_EQ(problem.plate.stiffness, 5e7);
  EXPECT_EQ(problem.plate.mass, 3.0);
  EXPECT_EQ(problem.plate.damping_ratio, 0.02);
}

}  // namespace
}  // namespace rebound
