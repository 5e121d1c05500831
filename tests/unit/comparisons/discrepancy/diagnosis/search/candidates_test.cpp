#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

constexpr double reach = 6.0;

/// An adequate fit of so many numbers to a thousand data.
AssessedFit adequate_fit(const std::vector<std::string>& effects, double chi_square,
                         double unknowns) {
  AssessedFit one;
  for (const std::string& name : effects) one.fit.effects.push_back({.name = name});
  one.fit.chi_square = chi_square;
  one.fit.effect_unknowns = unknowns;
  one.fit.information_criterion = chi_square + unknowns * std::log(1000.0);
  one.fit.prediction_criterion = chi_square + 2.0 * unknowns;
  one.judged = one.adequate = true;
  return one;
}

using Members = std::vector<std::size_t>;

TEST(CandidatesTest, ASetThatHoldsASmallerOneIsNone) {
  const std::vector<AssessedFit> tried{adequate_fit({"force-exponent"}, 1000.0, 1),
                                       adequate_fit({"hysteresis"}, 1001.0, 1),
                                       adequate_fit({"force-exponent", "gravity"}, 998.0, 1.3)};
  EXPECT_EQ(indistinguishable_models(tried, reach), (Members{0, 1}));
}

TEST(CandidatesTest, ASetStandsWhereTheSmallerOneIsNotAdequate) {
  std::vector<AssessedFit> tried{adequate_fit({"force-exponent"}, 1000.0, 1),
                                 adequate_fit({"force-exponent", "gravity"}, 998.0, 1.3)};
  tried[0].adequate = false;
  EXPECT_EQ(indistinguishable_models(tried, reach), (Members{1}));
}

TEST(CandidatesTest, ACurveMakesWayForAFormulaOfItsFamily) {
  const std::vector<AssessedFit> tried{adequate_fit({"elastic-curve"}, 990.0, 2),
                                       adequate_fit({"force-exponent"}, 1000.0, 1),
                                       adequate_fit({"unloading-curve"}, 990.0, 2)};
  EXPECT_EQ(indistinguishable_models(tried, reach), (Members{1, 2}));
}

// By χ² + k ln N the second is 14 beyond the first, by χ² + 2 k level with it; the third fits
// better than both, and pays 2 a number for it.
TEST(CandidatesTest, EitherCriterionKeepsACandidateAndBothCountItsNumbers) {
  const std::vector<AssessedFit> tried{adequate_fit({"hysteresis"}, 1006.0, 1),
                                       adequate_fit({"force-exponent", "gravity"}, 1002.0, 3),
                                       adequate_fit({"relaxation", "adhesion"}, 998.0, 9)};
  EXPECT_EQ(indistinguishable_models(tried, reach), (Members{0, 1}));
}

/// A curve that fits so well, and a formula beside it that leaves so much more.
std::vector<AssessedFit> curve_that_leaves(double remaining) {
  std::vector<AssessedFit> tried{adequate_fit({"unloading-curve"}, 1000.0, 4),
                                 adequate_fit({"hysteresis", "permanent-set"}, 1300.0, 2)};
  tried[1].adequate = false;
  tried[0].best_remaining = remaining;
  tried[0].remaining_threshold = 15.0;
  return tried;
}

TEST(CandidatesTest, ASearchMayEndWithACurveThatLeavesNothing) {
  EXPECT_TRUE(may_end_with(curve_that_leaves(14.0), {0}, 0));
}

TEST(CandidatesTest, ASearchMayNotEndWithACurveAloneThatLeavesStructure) {
  EXPECT_FALSE(may_end_with(curve_that_leaves(40.0), {0}, 0));
  EXPECT_TRUE(may_end_with(curve_that_leaves(40.0), {0, 1}, 0));
}

TEST(CandidatesTest, ASearchMayNotEndWithNothing) {
  EXPECT_FALSE(may_end_with({}, {}, 0));
}

// Of the first the numbers cost more than they gain by χ² + k ln N and not by χ² + 2 k; the second
// gains nothing by either, and the third only at the unseen speed.
TEST(CandidatesTest, WhatIsNoBetterThanNoEffectIsDropped) {
  AssessedFit none = adequate_fit({}, 1040.0, 0);
  none.unseen_chi_square = 100.0;
  std::vector<AssessedFit> tried{adequate_fit({"elastic-curve"}, 1010.0, 5),
                                 adequate_fit({"force-exponent"}, 1033.0, 1),
                                 adequate_fit({"hysteresis"}, 1033.0, 1)};
  tried[2].unseen_chi_square = 80.0;
  Members members{0, 1, 2};
  drop_what_gains_nothing(tried, none, reach, members);
  EXPECT_EQ(members, (Members{0, 2}));
}

}  // namespace
}  // namespace rebound
