#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

Observations shots_at(const std::vector<double>& speeds, double uncertainty) {
  Observations all;
  for (const double speed : speeds)
    all.shots.push_back({.impact = {.speed = speed}, .speed_uncertainty = uncertainty});
  return all;
}

TEST(HeldOutSpeedTest, MeasuredSpeedsOfOneNominalSpeedAreOneCluster) {
  const Observations all = shots_at({5.02, 14.89, 24.9, 14.96, 4.97, 14.97}, 0.05);
  const auto clusters = speed_clusters(all);
  ASSERT_EQ(clusters.size(), 3u);
  EXPECT_EQ(clusters[1].shots, (std::vector<std::size_t>{1, 3, 5}));
  EXPECT_NEAR(clusters[1].speed, 14.94, 1e-12);
  EXPECT_EQ(choose_held_out(all, std::nullopt)->shots, clusters[1].shots);
}

TEST(HeldOutSpeedTest, WellKnownSpeedsStayApart) {
  EXPECT_EQ(speed_clusters(shots_at({10.0, 10.5, 11.0}, 0.01)).size(), 3u);
  EXPECT_EQ(speed_clusters(shots_at({10.0, 10.5, 11.0}, 0.5)).size(), 1u);
}

TEST(HeldOutSpeedTest, TwoSpeedsLeaveNoneOut) {
  EXPECT_FALSE(choose_held_out(shots_at({5.0, 5.01, 15.0}, 0.02), std::nullopt));
}

TEST(HeldOutSpeedTest, AnAskedSpeedIsFoundByItsUncertainty) {
  const Observations all = shots_at({5.02, 14.89, 24.9}, 0.05);
  EXPECT_EQ(choose_held_out(all, 25.0)->shots, (std::vector<std::size_t>{2}));
  const Error refused = testing::refusal_of([&] { choose_held_out(all, 20.0); });
  EXPECT_EQ(refused.code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
