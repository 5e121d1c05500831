#include "comparisons/models/instrument/reported_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

TEST(ReportedForceTest, OutsideTheContactThereIsTheBaselineAlone) {
  const std::vector<double> time{-1e-3, 2.5e-3};
  const auto force = reported_force(half_sine(), {.force_baseline = 7.0}, time);
  EXPECT_EQ(force, (std::vector<double>{7.0, 7.0}));
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

TEST(ReportedForceTest, ATraceOfOneSampleIsRefused) {
  EXPECT_THROW(reported_force({.time = {0.0}, .force = {1.0}}, {}, std::vector<double>{0.0}),
               Error);
}

}  // namespace
}  // namespace rebound
