#include "comparisons/models/instrument/droop.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

/// One newton from first touch to `end`, on samples that are not even.
Trace step_force(double end) {
  Trace trace;
  for (int i = 0; i <= 100; ++i) {
    const double share = i / 100.0;
    trace.time.push_back(end * share * share);
    trace.force.push_back(1.0);
  }
  return trace;
}

TEST(DroopTest, AStepDecaysByTheTimeConstant) {
  constexpr double rate = 200.0;
  const Trace passed = with_droop(step_force(10e-3), rate, 10e-3);
  ASSERT_EQ(passed.time.size(), 101u);
  for (std::size_t i = 0; i < passed.time.size(); ++i)
    EXPECT_NEAR(passed.force[i], std::exp(-rate * passed.time[i]), 1e-13);
}

TEST(DroopTest, ARampApproachesItsSlopeOverTheRate) {
  // y' = a - s y: y = a/s (1 - e^{-st}).
  constexpr double rate = 500.0, slope = 3e5;
  Trace ramp;
  for (int i = 0; i <= 50; ++i) {
    ramp.time.push_back(2e-4 * i);
    ramp.force.push_back(slope * ramp.time.back());
  }
  const Trace passed = with_droop(ramp, rate, 0.0);
  for (std::size_t i = 0; i < passed.time.size(); ++i)
    EXPECT_NEAR(passed.force[i], slope / rate * -std::expm1(-rate * passed.time[i]), 1e-9);
}

TEST(DroopTest, AfterTheContactTheRecordUndershootsAndComesBack) {
  constexpr double rate = 200.0, end = 1e-3;
  const Trace passed = with_droop(step_force(end), rate, 20e-3);
  EXPECT_GT(passed.time.back(), 20e-3 - 1e-12);
  for (std::size_t i = 101; i < passed.time.size(); ++i) {
    const double t = passed.time[i];
    EXPECT_NEAR(passed.force[i], std::exp(-rate * t) - std::exp(-rate * (t - end)), 1e-12);
    EXPECT_LT(passed.force[i], 0.0);
  }
}

TEST(DroopTest, WithoutARateNothingChanges) {
  const Trace force = step_force(1e-3), passed = with_droop(force, 0.0, 5e-3);
  EXPECT_EQ(passed.time, force.time);
  EXPECT_EQ(passed.force, force.force);
}

}  // namespace
}  // namespace rebound
