#include "comparisons/studies/reproduce/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

TEST(IntervalTest, CornersAreExactForMonotoneFormulas) {
  // x/y + sqrt(x): rising in x, falling in y; its ends are known in closed form.
  const Formula formula = [](const std::vector<double>& in) {
    return in[0] / in[1] + std::sqrt(in[0]);
  };
  const Interval range = corner_range(formula, {{4.0, 0.5}, {2.0, 0.1}});
  EXPECT_DOUBLE_EQ(range.low, 3.5 / 2.1 + std::sqrt(3.5));
  EXPECT_DOUBLE_EQ(range.high, 4.5 / 1.9 + std::sqrt(4.5));
}

TEST(IntervalTest, AnInputThatEntersTwiceIsOneInput) {
  const Formula always_one = [](const std::vector<double>& in) { return in[0] / in[0]; };
  const Interval range = corner_range(always_one, {{4.0, 0.5}});
  EXPECT_DOUBLE_EQ(range.low, 1.0);
  EXPECT_DOUBLE_EQ(range.high, 1.0);
}

TEST(IntervalTest, ChosenNumbersHaveNoWidth) {
  const Formula square = [](const std::vector<double>& in) { return in[0] * in[0]; };
  const Interval range = corner_range(square, {exactly(3.0)});
  EXPECT_EQ(range.low, 9.0);
  EXPECT_EQ(range.high, 9.0);
}

TEST(IntervalTest, MagnitudeOfAnIntervalAcrossZeroStartsAtZero) {
  EXPECT_EQ(magnitude({-1.0, 3.0}).low, 0.0);
  EXPECT_EQ(magnitude({-1.0, 3.0}).high, 3.0);
  EXPECT_EQ(magnitude({-3.0, -1.0}).low, 1.0);
  EXPECT_EQ(magnitude({-3.0, -1.0}).high, 3.0);
  EXPECT_EQ(magnitude({1.0, 3.0}).low, 1.0);
}

TEST(IntervalTest, MeanAndLargestGoEndByEnd) {
  const std::vector<Interval> intervals{{0.0, 4.0}, {2.0, 3.0}};
  EXPECT_EQ(mean_of(intervals).low, 1.0);
  EXPECT_EQ(mean_of(intervals).high, 3.5);
  EXPECT_EQ(largest_of(intervals).low, 2.0);
  EXPECT_EQ(largest_of(intervals).high, 4.0);
}

TEST(IntervalTest, TouchingIntervalsOverlap) {
  EXPECT_TRUE(overlap({0.0, 1.0}, {1.0, 2.0}));
  EXPECT_FALSE(overlap({0.0, 1.0}, {1.1, 2.0}));
}

}  // namespace
}  // namespace rebound
