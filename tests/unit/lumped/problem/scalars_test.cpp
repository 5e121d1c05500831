#include "lumped/problem/scalars.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

/// Half a sine of amplitude 1 and duration 1; the peak lies between samples.
Trace half_sine(int intervals) {
  Trace trace;
  for (int i = 0; i <= intervals; ++i) {
    const double t = static_cast<double>(i) / intervals;
    trace.time.push_back(t);
    trace.force.push_back(std::sin(std::numbers::pi * t));
    trace.deflection.push_back(t);
  }
  return trace;
}

TEST(ScalarsTest, ParabolaFindsPeakOfSine) {
  const auto error = [](int intervals) {
    const Trace trace = half_sine(intervals);
    return std::abs(refined_peak(trace.time, trace.force) - 1.0);
  };
  EXPECT_LT(error(41), 1e-5);             // the highest sample alone is 7e-4 off
  EXPECT_GT(error(41) / error(83), 7.0);  // third order or better: 2³ less a little
}

TEST(ScalarsTest, TimeAboveInterpolatesBothCrossings) {
  const double expected = 1.0 - 2.0 * std::asin(0.5) / std::numbers::pi;
  EXPECT_NEAR(time_above(half_sine(1001), 0.5), expected, 1e-5);
  EXPECT_EQ(time_above(half_sine(1001), 2.0), 0.0);
}

TEST(ScalarsTest, MeanDeflectionStopsAtSeparation) {
  // x = t: the mean over [0, T] is T/2, also where T falls between samples.
  const ImpactScalars scalars = derive_scalars(half_sine(10), {.speed = 2.0}, 0.55, 1.0);
  EXPECT_NEAR(scalars.mean_deflection, 0.275, 1e-12);
  EXPECT_EQ(scalars.restitution, 0.5);
}

TEST(ScalarsTest, OnePerCentOfThePeakIsTheThreshold) {
  const ImpactScalars scalars = derive_scalars(half_sine(10001), {.speed = 2.0}, 1.0, 1.0);
  EXPECT_NEAR(scalars.contact_time_1pct, 1.0 - 2.0 * std::asin(0.01) / std::numbers::pi, 1e-7);
}

TEST(ScalarsTest, AreOfTheContactForce) {
  // A load cell that rings on with a third of the peak after the ball has left.
  Trace trace = half_sine(1000), measured = trace;
  for (int i = 0; i < 200; ++i) {
    trace.time.push_back(1.0 + 0.001 * (i + 1));
    trace.force.push_back(0.0);
    trace.deflection.push_back(1.0);
  }
  measured = trace;
  measured.further = {{contact_force_column, trace.force}};
  for (std::size_t i = 0; i < measured.force.size(); ++i)
    measured.force[i] += 0.3 * std::sin(40.0 * measured.time[i]);
  const ImpactScalars expected = derive_scalars(trace, {.speed = 2.0}, 1.0, 1.0);
  const ImpactScalars found = derive_scalars(measured, {.speed = 2.0}, 1.0, 1.0);
  EXPECT_EQ(found.contact_time_1pct, expected.contact_time_1pct);
  EXPECT_EQ(found.peak_force, expected.peak_force);
  EXPECT_GT(time_above(measured, 0.01), 1.1);
  measured.further.front().values.pop_back();
  EXPECT_EQ(testing::refusal_of([&] { derive_scalars(measured, {.speed = 1.0}, 1.0, 0.5); }).code(),
            ExitCode::bad_input);
}

TEST(ScalarsTest, RefusesUnequalColumns) {
  Trace trace = half_sine(10);
  trace.force.pop_back();
  EXPECT_EQ(testing::refusal_of([&] { derive_scalars(trace, {.speed = 1.0}, 1.0, 0.5); }).code(),
            ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
