#include "comparisons/models/instrument/reported_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lumped/integration/sample_instants.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Trace half_sine() {
  Trace trace;
  for (int i = 0; i <= 400; ++i) {
    trace.time.push_back(i * 5e-6);
    trace.force.push_back(1000.0 * std::sin(std::numbers::pi * i / 400.0));
  }
  return trace;
}

TEST(ReportedForceTest, IdealChainChangesNothing) {
  const Trace contact = half_sine();
  EXPECT_EQ(reported_force(contact, {}, contact.time), contact.force);
}

/// Largest error of what is read of t^power, over its value at the end, from a twentieth of an even
/// step on.
double error_of_power(double power, bool finer_ends) {
  const LumpedControls controls{.samples = 201, .finer_ends = finer_ends};
  Trace contact;
  contact.time.resize(sample_count(controls));
  fill_sample_instants(2e-3, controls, contact.time);
  const auto force = [&](double t) { return std::pow(t / 2e-3, power); };
  for (const double t : contact.time) contact.force.push_back(force(t));
  std::vector<double> between;
  for (double t = 5e-7; t < 2e-3; t += 1.3e-7) between.push_back(t);
  const std::vector<double> read = reported_force(contact, {}, between);
  double worst = 0.0;
  for (std::size_t i = 0; i < between.size(); ++i)
    worst = std::max(worst, std::abs(read[i] - force(between[i])));
  return worst;
}

// Hertz, a plate that yields, a dashpot's rise, and Tsuji's damper.
TEST(ReportedForceTest, FinerEndsFollowAnyPower) {
  for (const double power : {2.5, 1.5, 1.0, 0.25})
    EXPECT_LT(error_of_power(power, true), 2e-4) << power;
  EXPECT_GT(error_of_power(0.25, false), 1e-2);
}

TEST(ReportedForceTest, BetweenSamplesItIsCubic) {
  const auto sine = [](double t) { return 1000.0 * std::sin(std::numbers::pi * t / 2e-3); };
  Trace contact;
  for (int i = 0; i <= 200; ++i) {
    contact.time.push_back(i * 1e-5);
    contact.force.push_back(sine(contact.time.back()));
  }
  std::vector<double> between;
  for (int i = 0; i < 2000; ++i) between.push_back(i * 1e-6);
  const auto force = reported_force(contact, {}, between);
  for (std::size_t i = 0; i < between.size(); ++i)
    EXPECT_NEAR(force[i], sine(between[i]), 1e-6 * 1000.0);
}

TEST(ReportedForceTest, OutsideTheContactThereIsTheBaselineAlone) {
  const std::vector<double> time{-1e-3, 2.5e-3};
  const auto force = reported_force(half_sine(), {.force_baseline = 7.0}, time);
  EXPECT_EQ(force, (std::vector<double>{7.0, 7.0}));
}

/// Where a contact ends with a slope, and nowhere else; a jump stays one.
TEST(ReportedForceTest, AnApertureTakesTheKinkFromAnEnd) {
  const Trace ramp{.time = {0.0, 1e-3, 2e-3}, .force = {400.0, 200.0, 0.0}};
  const double width = 1e-5, half = 0.5 * width, slope = 2e5;
  const std::vector<double> time{-half, 0.0, half, 1e-3, 2e-3 - half, 2e-3, 2e-3 + half};
  const auto force = reported_force(ramp, {.aperture = width}, time);
  const std::vector<double> expected{
      0.0, 400.0, 400.0 - slope * half, 200.0, slope * half, slope * width / 8, 0.0};
  for (std::size_t i = 0; i < time.size(); ++i) EXPECT_NEAR(force[i], expected[i], 1e-6) << time[i];
  const auto ideal = reported_force(ramp, {}, time);
  EXPECT_EQ(force[3], ideal[3]);
  const double step = 1e-8;
  const auto about_the_end = reported_force(ramp, {.aperture = width},
                                            std::vector<double>{2e-3 - step, 2e-3, 2e-3 + step});
  EXPECT_NEAR((about_the_end[1] - about_the_end[0]) / step, -0.5 * slope, 0.01 * slope);
  EXPECT_NEAR((about_the_end[2] - about_the_end[1]) / step, -0.5 * slope, 0.01 * slope);
}

TEST(ReportedForceTest, GainBaselineAndClock) {
  const MeasurementChain chain{.force_gain = 0.1, .force_baseline = 5.0, .trigger_shift = 1e-3};
  const auto force = reported_force(half_sine(), chain, std::vector<double>{2e-3});
  EXPECT_NEAR(force[0], 1.1 * 1000.0 + 5.0, 1e-9);  // the peak, 1 ms late
}

TEST(ReportedForceTest, ABandwidthLowersAndDelaysThePeakAndKeepsTheImpulse) {
  const Trace contact = half_sine();
  std::vector<double> time;
  for (int i = 0; i < 6000; ++i) time.push_back(i * 5e-6);
  const auto ideal = reported_force(contact, {}, time);
  const auto slow = reported_force(contact, {.bandwidth = 300.0}, time);
  const auto top = [](const std::vector<double>& f) {
    return std::max_element(f.begin(), f.end());
  };
  EXPECT_LT(*top(slow), 0.95 * *top(ideal));
  EXPECT_GT(top(slow) - slow.begin(), top(ideal) - ideal.begin());
  double kept = 0.0, sent = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    kept += slow[i];
    sent += ideal[i];
  }
  EXPECT_NEAR(kept / sent, 1.0, 1e-3);
}

TEST(ReportedForceTest, AFastClockStretchesARamp) {
  const Trace ramp{.time = {0.0, 1e-3}, .force = {0.0, 100.0}};
  const MeasurementChain chain{.trigger_shift = 2e-3, .time_base = 0.25};
  const auto force = reported_force(ramp, chain, std::vector<double>{2.5e-3, 3.125e-3, 3.25e-3});
  EXPECT_NEAR(force[0], 40.0, 1e-9);  // 0.5 ms as read is 0.4 ms
  EXPECT_NEAR(force[1], 90.0, 1e-9);
  EXPECT_NEAR(force[2], 100.0, 1e-6);
}

TEST(ReportedForceTest, ClippingNeverExceedsItsLevelAndLeavesWhatIsBelow) {
  const Trace contact = half_sine();
  const auto whole = reported_force(contact, {.force_baseline = 5.0}, contact.time);
  const auto clipped =
      reported_force(contact, {.force_baseline = 5.0, .clipping_level = 700.0}, contact.time);
  EXPECT_EQ(*std::max_element(clipped.begin(), clipped.end()), 700.0);
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(clipped[i], std::min(whole[i], 700.0));
}

TEST(ReportedForceTest, DroopTakesTheImpulseBackInTheEnd) {
  const Trace contact = half_sine();
  std::vector<double> time;
  for (int i = 0; i < 20000; ++i) time.push_back(i * 5e-6);
  double sum = 0.0, largest = 0.0;
  for (const double force : reported_force(contact, {.droop = 300.0}, time)) {
    sum += force;
    largest = std::max(largest, std::abs(sum));
  }
  EXPECT_LT(std::abs(sum), 1e-4 * largest);
}

// Long after its start a ramp is late by the time constants of both poles together.
TEST(ReportedForceTest, BothLagsDelayARamp) {
  Trace ramp;
  for (int i = 0; i <= 4000; ++i) {
    ramp.time.push_back(i * 1e-6);
    ramp.force.push_back(1e5 * ramp.time.back());
  }
  const MeasurementChain chain{.lag = 1e-4, .second_lag = 5e-5};
  const auto force = reported_force(ramp, chain, std::vector<double>{3e-3});
  EXPECT_NEAR(force[0], 1e5 * (3e-3 - 1.5e-4), 1e-6);
}

TEST(ReportedForceTest, ABandwidthThatTheSamplesCannotShowPassesAll) {
  const Trace contact = half_sine();
  EXPECT_EQ(reported_force(contact, {.bandwidth = 1e6}, contact.time), contact.force);
}

TEST(ReportedForceTest, AChainOutOfItsLimitsIsRefused) {
  const Trace contact = half_sine();
  for (const MeasurementChain& chain :
       {MeasurementChain{.droop = -1.0}, MeasurementChain{.time_base = -1.0},
        MeasurementChain{.clipping_level = 0.0}, MeasurementChain{.bandwidth = -1.0}})
    EXPECT_THROW(reported_force(contact, chain, contact.time), Error);
}

TEST(ReportedForceTest, ATraceOfOneSampleIsRefused) {
  EXPECT_THROW(reported_force({.time = {0.0}, .force = {1.0}}, {}, std::vector<double>{0.0}),
               Error);
}

// A filter of an SAE J211 class has no delay: the peak stays where it was, lower by what the filter
// takes of a half sine, and the smear reaches as far before first touch as after the end.
TEST(ReportedForceTest, AFilterOfAClassLowersWithoutDelay) {
  const Trace contact = half_sine();
  std::vector<double> time;
  for (int i = -400; i <= 800; ++i) time.push_back(i * 5e-6);
  const auto force = reported_force(contact, {.filter_class = 180.0}, time);
  const auto peak = std::max_element(force.begin(), force.end());
  EXPECT_NEAR(time[static_cast<std::size_t>(peak - force.begin())], 1e-3, 1e-5);
  EXPECT_LT(*peak, 950.0);
  EXPECT_GT(*peak, 500.0);
  for (int k = 0; k <= 500; k += 50)  // even about the middle of the contact
    EXPECT_NEAR(force[static_cast<std::size_t>(600 + k)], force[static_cast<std::size_t>(600 - k)],
                1.0);
  EXPECT_GT(force[380], 10.0);  // before first touch
  const auto wide = reported_force(contact, {.filter_class = 1e5}, contact.time);
  for (std::size_t i = 20; i + 20 < wide.size(); ++i) EXPECT_NEAR(wide[i], contact.force[i], 0.5);
}

}  // namespace
}  // namespace rebound
