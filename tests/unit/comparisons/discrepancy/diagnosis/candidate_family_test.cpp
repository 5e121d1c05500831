#include "comparisons/discrepancy/diagnosis/candidate_family.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

const std::vector<EffectSet> sticky{{"adhesion", "damping-exponent"},
                                    {"pull-curves", "force-exponent"}};

TEST(CandidateFamilyTest, CommonOnlyWhereAllEffectsAreOfIt) {
  EXPECT_EQ(common_family({{"force-exponent"}, {"elastic-curve"}}), EffectFamily::elastic);
  EXPECT_EQ(common_family({{"force-exponent"}, {"relaxation"}}), EffectFamily::none);
  EXPECT_EQ(common_family(sticky), EffectFamily::none);
}

TEST(CandidateFamilyTest, MainWhereOneExplainsFourFifthsByItself) {
  EXPECT_EQ(main_family(sticky, {{{"adhesion"}, 0.85}, {{"damping-exponent"}, 0.6}}),
            EffectFamily::surface);
  EXPECT_EQ(main_family(sticky, {{{"adhesion"}, 0.75}}), EffectFamily::none);
}

TEST(CandidateFamilyTest, NoMainFamilyThatACandidateDoesWithout) {
  const ExplainedShare elastic{{"force-exponent"}, 0.95};
  EXPECT_EQ(main_family(sticky, {elastic}), EffectFamily::none);
  EXPECT_EQ(main_family({{"force-exponent", "hum"}}, {elastic}), EffectFamily::elastic);
}

TEST(CandidateFamilyTest, NoMainFamilyWhereTwoExplainMost) {
  const std::vector<EffectSet> both{{"adhesion", "force-exponent"}};
  EXPECT_EQ(main_family(both, {{{"adhesion"}, 0.9}, {{"force-exponent"}, 0.85}}),
            EffectFamily::none);
}

TEST(CandidateFamilyTest, NearestFormulasAreThoseThatExplainHalfAloneAndNoFreeForm) {
  const auto nearest =
      nearest_formulas(EffectFamily::history, {{{"hysteresis"}, 0.7},
                                               {{"permanent-set"}, 0.9},
                                               {{"unloading-curve"}, 1.0},
                                               {{"permanent-set", "hysteresis"}, 1.0},
                                               {{"damping-exponent"}, 0.95}});
  ASSERT_EQ(nearest.size(), 2u);
  EXPECT_EQ(nearest[0].effects, EffectSet{"permanent-set"});
  EXPECT_EQ(nearest[1].effects, EffectSet{"hysteresis"});
  EXPECT_TRUE(nearest_formulas(EffectFamily::history, {{{"hysteresis"}, 0.4}}).empty());
}

}  // namespace
}  // namespace rebound
