// Chances of a gap against rises of χ², and sizes that raise it.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/design/hidden_sizes.hpp"
#include "comparisons/discrepancy/design/linear_rows.hpp"
#include "comparisons/discrepancy/design/refitted_change.hpp"
#include "comparisons/discrepancy/design/rise_of_chance.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

TEST(RiseOfChanceTest, TheThresholdIsPassedInHalfOfAllTests) {
  constexpr double threshold = 15.0;
  EXPECT_NEAR(rise_of_chance(0.5, threshold), threshold, 1e-12);
  for (const double chance : {0.2, 0.9}) {
    const double surplus = std::sqrt(rise_of_chance(chance, threshold)) - std::sqrt(threshold);
    EXPECT_NEAR(0.5 * std::erfc(-surplus / std::sqrt(2.0)), chance, 1e-9);
  }
  EXPECT_EQ(rise_of_chance(1e-9, 4.0), 0.0);  // noise alone is found more often
}

TEST(HiddenSizesTest, TheSizeRaisesChiSquareByWhatWasAsked) {
  const PlannedData data = planned_data(testing::experiment_with({}, 5));
  for (const char* name : {"relaxation", "strain-stiffening", "permanent-set"}) {
    const auto least = least_visible(*data.around, find_effect(name).card, 25.0);
    ASSERT_TRUE(least) << name;
    EXPECT_NEAR(*data.around->rise(least->effect), 25.0, 1.5) << name;
  }
}

TEST(RefittedChangeTest, ASmallEffectLeavesWhatFirstOrderSays) {
  const PlannedData data = planned_data(testing::experiment_with({}, 5));
  const RefittedChange refitted(data);
  const EffectSensitivity* own = nullptr;
  for (const EffectSensitivity& one : data.around->all())
    if (one.effect.name == "strain-stiffening" && !own) own = &one;  // the plain formula
  ASSERT_TRUE(own);
  EffectChoice small = own->effect;
  small.size = 0.012;
  const auto left = refitted.by(small);
  ASSERT_TRUE(left);
  const Eigen::VectorXd first = 0.012 * own->sensitivity;
  EXPECT_LT((data.around->project(*left) - first).norm(), 0.1 * first.norm());
}

TEST(LinearRowsTest, WhatTheFitTakesUpIsSeenNowhere) {
  const PlannedData data = planned_data(testing::experiment_with({}, 5));
  const LinearRows rows(data);
  ASSERT_TRUE(rows.has_unseen());
  const Eigen::MatrixXd taken = free_jacobian(*data.fit);
  for (Eigen::Index j = 0; j < taken.cols(); ++j) {
    const double length = taken.col(j).norm();
    EXPECT_LT(rows.seen(taken.col(j)).norm(), 1e-8 * length + 1e-12) << j;
    EXPECT_LT(rows.unseen(taken.col(j)).norm(), 1e-6 * length + 1e-12) << j;
  }
}

}  // namespace
}  // namespace rebound
