#include "comparisons/inference/calibration/effect_unknowns.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

TEST(EffectUnknownsTest, ALinearParameterIsItself) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns hum({{"hum", 30.0, {{"frequency", 700.0}, {"phase", -1.5}}}}, false,
                           unknowns);
  ASSERT_EQ(unknowns.size(), 3u);
  EXPECT_EQ(unknowns[0].start, 30.0);
  EXPECT_DOUBLE_EQ(unknowns[1].start, std::log(700.0));
  EXPECT_EQ(unknowns[2].start, -1.5);
  EXPECT_LT(unknowns[2].lowest, 0.0);
  const EffectChoice moved = hum.at({-20.0, std::log(800.0), -2.5})[0];
  EXPECT_EQ(moved.size, -20.0);
  EXPECT_NEAR(moved.parameters.at("frequency"), 800.0, 1e-9);
  EXPECT_EQ(moved.parameters.at("phase"), -2.5);
}

TEST(EffectUnknownsTest, TheSizeOfAPlateIsALogarithm) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns plate({{"plate-compliance", 2e-8, {{"mass", 5.0}}}}, false, unknowns);
  EXPECT_DOUBLE_EQ(unknowns[0].start, std::log(2e-8));
  EXPECT_NEAR(plate.at({std::log(3e-8), 0.0, -3.0})[0].size, 3e-8, 1e-20);
}

// Thirty shots tell a loop of a five-hundredth. A search that kept off nothing by a hundredth of
// what is usual began, and ended, at more than was there.
TEST(EffectUnknownsTest, ASmallSizeIsWithinReach) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns loop({{"hysteresis", 0.0, {}}}, false, unknowns);
  EXPECT_GT(unknowns[0].lowest, 0.0);
  EXPECT_LT(unknowns[0].lowest, 5e-5);
  EXPECT_EQ(unknowns[0].start, unknowns[0].lowest);
}

// What unloading without a formula takes at one place it may give at another.
TEST(EffectUnknownsTest, AFreeFormHasNoSideOfNothing) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns curve({{"unloading-curve", 0.0, {}}}, false, unknowns);
  EXPECT_LT(unknowns[0].lowest, -0.1);
  EXPECT_EQ(unknowns[0].start, 0.0);
}

TEST(EffectUnknownsTest, AShotIsNoUnknown) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns gain({{"shot-gain", 0.1, {{"shot", 2.0}}}}, false, unknowns);
  EXPECT_EQ(unknowns.size(), 1u);
  EXPECT_EQ(gain.at({0.2})[0].parameters.at("shot"), 2.0);
}

TEST(EffectUnknownsTest, BallsMayHaveSizesOfTheirOwn) {
  std::vector<CalibrationParameter> unknowns;
  const EffectUnknowns relaxation({{"relaxation", 0.3, {{"relaxation_time", 1e-3}}, {0.3, 0.6}}},
                                  false, unknowns);
  ASSERT_EQ(unknowns.size(), 3u);
  EXPECT_EQ(relaxation.sizes(0), 2u);
  EXPECT_EQ(unknowns[1].start, 0.6);
  EXPECT_EQ(relaxation.places_of_ball(0, 1), (std::vector<std::size_t>{1, 2}));
  const auto moved = relaxation.at({0.2, 0.5, std::log(2e-3)});
  EXPECT_EQ(effects_of_ball(moved, 0)[0].size, 0.2);
  EXPECT_EQ(effects_of_ball(moved, 1)[0].size, 0.5);
  EXPECT_NEAR(moved[0].parameters.at("relaxation_time"), 2e-3, 1e-9);
}

}  // namespace
}  // namespace rebound
