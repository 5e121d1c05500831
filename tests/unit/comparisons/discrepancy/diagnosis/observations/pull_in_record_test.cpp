// A ball that sticks pulls before and after its push.
#include "comparisons/discrepancy/diagnosis/observations/pull_in_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rebound {
namespace {

constexpr std::size_t quiet = 100, push = 200, samples = 700;
constexpr double peak = 1000.0, noise = 5.0;
constexpr SampleRange pushing{quiet, quiet + push - 1};

/// A half sine of force among noise, to which the tests add.
std::vector<double> pushed() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> scatter(0.0, noise);
  std::vector<double> force(samples);
  for (double& one : force) one = scatter(random);
  for (std::size_t i = 0; i < push; ++i)
    force[quiet + i] +=
        peak * std::sin(std::numbers::pi * static_cast<double>(i) / static_cast<double>(push));
  return force;
}

std::vector<double> pulled(std::size_t first, std::size_t count, double by = 40.0) {
  std::vector<double> force = pushed();
  for (std::size_t i = first; i < first + count; ++i) force[i] -= by;
  return force;
}

TEST(PullInRecordTest, ThereIsNoneInAPush) {
  const SampleRange kept = with_pull(pushing, pushed(), 0.0);
  EXPECT_EQ(kept.first, pushing.first);
  EXPECT_EQ(kept.last, pushing.last);
}

TEST(PullInRecordTest, AfterThePushItBelongsToTheContact) {
  const SampleRange kept = with_pull(pushing, pulled(quiet + push, 90), 0.0);
  EXPECT_EQ(kept.first, pushing.first);
  EXPECT_NEAR(static_cast<double>(kept.last), quiet + push + 90, 10.0);
}

TEST(PullInRecordTest, BeforeThePushItIsNoQuiet) {
  const SampleRange kept = with_pull(pushing, pulled(quiet - 30, 30), 0.0);
  EXPECT_NEAR(static_cast<double>(kept.first), quiet - 30, 10.0);
  EXPECT_EQ(kept.last, pushing.last);
}

TEST(PullInRecordTest, ItEndsAfterOneContactAtMost) {
  const SampleRange kept = with_pull(pushing, pulled(quiet + push, 350), 0.0);
  EXPECT_LE(kept.last, pushing.last + push);
}

TEST(PullInRecordTest, ARingIsNone) {
  std::vector<double> force = pushed();
  for (std::size_t i = quiet + push; i < samples; ++i)
    force[i] -= 40.0 * std::sin(std::numbers::pi * static_cast<double>(i - quiet - push) / 60.0);
  EXPECT_EQ(with_pull(pushing, force, 0.0).last, pushing.last);
}

TEST(PullInRecordTest, ARecordThatEndsTooSoonDoesNotTellItFromARing) {
  std::vector<double> force = pulled(quiet + push, 90);
  force.resize(quiet + push + 120);
  EXPECT_EQ(with_pull(pushing, force, 0.0).last, pushing.last);
}

TEST(PullInRecordTest, NoiseAndRoundingAreNone) {
  EXPECT_EQ(with_pull(pushing, pulled(quiet + push, 90, noise), 0.0).last, pushing.last);
  EXPECT_EQ(with_pull(pushing, pulled(quiet + push, 90), 40.0).last, pushing.last);
}

}  // namespace
}  // namespace rebound
