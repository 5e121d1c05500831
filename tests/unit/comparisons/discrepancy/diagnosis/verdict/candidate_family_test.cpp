#include "comparisons/discrepancy/diagnosis/verdict/candidate_family.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

const std::vector<FamilySet> sticky{{EffectFamily::surface, EffectFamily::rate},
                                    {EffectFamily::surface, EffectFamily::elastic}};

TEST(CandidateFamilyTest, CommonOnlyWhereAllEffectsAreOfIt) {
  using enum EffectFamily;
  EXPECT_EQ(common_family({{elastic}, {elastic}}), elastic);
  EXPECT_EQ(common_family({{elastic}, {memory}}), none);
  EXPECT_EQ(common_family(sticky), none);
}

TEST(CandidateFamilyTest, MainWhereOneExplainsFourFifthsByItself) {
  using enum EffectFamily;
  EXPECT_EQ(
      main_family(sticky, {{{"adhesion"}, {surface}, 0.85}, {{"damping-exponent"}, {rate}, 0.6}}),
      surface);
  EXPECT_EQ(
      main_family(sticky, {{{"adhesion"}, {surface}, 0.75}, {{"damping-exponent"}, {rate}, 0.6}}),
      none);
}

// A pull with more reach than the curve has: with any effect beside it more is explained, and that
// effect alone explains nothing.
TEST(CandidateFamilyTest, MainWhereNoOtherFamilyExplainsAnythingByItself) {
  using enum EffectFamily;
  EXPECT_EQ(main_family(sticky,
                        {{{"pull-curves"}, {surface}, 0.64}, {{"damping-exponent"}, {rate}, 0.04}}),
            surface);
  EXPECT_EQ(main_family(sticky,
                        {{{"pull-curves"}, {surface}, 0.64}, {{"damping-exponent"}, {rate}, 0.2}}),
            none);
  EXPECT_EQ(main_family(sticky, {{{"pull-curves"}, {surface}, 0.45}}), none);
}

TEST(CandidateFamilyTest, NoMainFamilyThatACandidateDoesWithout) {
  using enum EffectFamily;
  const ExplainedShare most{{"force-exponent"}, {elastic}, 0.95};
  EXPECT_EQ(main_family(sticky, {most}), none);
  EXPECT_EQ(main_family({{elastic, measurement}}, {most}), elastic);
}

TEST(CandidateFamilyTest, NoMainFamilyWhereTwoExplainMost) {
  using enum EffectFamily;
  const std::vector<FamilySet> both{{surface, elastic}};
  EXPECT_EQ(
      main_family(both, {{{"adhesion"}, {surface}, 0.9}, {{"force-exponent"}, {elastic}, 0.85}}),
      none);
}

// Beside an elastic curve that leaves hardly anything, damping that follows the force explains most
// of the gap by itself, too, and leaves many times as much.
TEST(CandidateFamilyTest, MainOfTwoIsTheOneThatLeavesFarLess) {
  using enum EffectFamily;
  const std::vector<FamilySet> both{{elastic, rate}};
  const ExplainedShare damping{{"damping-curves"}, {rate}, 0.9};
  EXPECT_EQ(main_family(both, {{{"elastic-curve"}, {elastic}, 0.98}, damping}), elastic);
  EXPECT_EQ(main_family(both, {{{"elastic-curve"}, {elastic}, 0.97}, damping}), none);
}

TEST(CandidateFamilyTest, NearestFormulasAreThoseThatExplainHalfAloneAndNoFreeForm) {
  using enum EffectFamily;
  const auto nearest =
      nearest_formulas(history, {{{"hysteresis"}, {history}, 0.7},
                                 {{"permanent-set"}, {history}, 0.9},
                                 {{"unloading-curve"}, {history}, 1.0},
                                 {{"permanent-set", "hysteresis"}, {history, history}, 1.0},
                                 {{"damping-exponent"}, {rate}, 0.95}});
  ASSERT_EQ(nearest.size(), 2u);
  EXPECT_EQ(nearest[0].effects, std::vector<std::string>{"permanent-set"});
  EXPECT_EQ(nearest[1].effects, std::vector<std::string>{"hysteresis"});
  EXPECT_TRUE(nearest_formulas(history, {{{"hysteresis"}, {history}, 0.4}}).empty());
}

}  // namespace
}  // namespace rebound
