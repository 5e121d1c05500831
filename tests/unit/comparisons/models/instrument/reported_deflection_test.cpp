#include "comparisons/models/instrument/reported_deflection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double pulse_duration = 2e-3, largest = 5e-3;

double deflection(double t) {
  return largest * std::sin(std::numbers::pi * t / pulse_duration);
}

Trace spring_contact() {
  Trace trace;
  for (int i = 0; i <= 200; ++i) {
    trace.time.push_back(1e-5 * i);
    trace.force.push_back(0.0);
    trace.deflection.push_back(deflection(trace.time.back()));
  }
  return trace;
}

TEST(ReportedDeflectionTest, IdealChainChangesNothing) {
  const Trace contact = spring_contact();
  EXPECT_EQ(reported_deflection(contact, {}, contact.time), contact.deflection);
  // A ball in free flight before and after, as fast as the trace ends.
  const std::vector<double> outside{-1e-4, pulse_duration + 1e-4};
  const double flown = largest * std::numbers::pi / pulse_duration * 1e-4;
  for (const double x : reported_deflection(contact, {}, outside))
    EXPECT_NEAR(x, -flown, 1e-3 * flown);
}

TEST(ReportedDeflectionTest, BetweenSamplesItIsCubic) {
  std::vector<double> between;
  for (int i = 0; i < 2000; ++i) between.push_back(1e-6 * i);
  const auto x = reported_deflection(spring_contact(), {}, between);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i], deflection(between[i]), 1e-6 * largest);
}

TEST(ReportedDeflectionTest, GainZeroAndDelayAreTheChains) {
  const MeasurementChain chain{
      .force_gain = 0.3, .trigger_shift = 1e-4, .deflection_gain = 0.1, .deflection_zero = 1e-3};
  const std::vector<double> when{6e-4};
  EXPECT_NEAR(reported_deflection(spring_contact(), chain, when)[0], 1.1 * deflection(5e-4) + 1e-3,
              1e-8);
}

TEST(ReportedDeflectionTest, RefusesAChainOutOfItsLimits) {
  const std::vector<double> when{1e-3};
  EXPECT_THROW(reported_deflection(spring_contact(), {.time_base = -2.0}, when), Error);
}

}  // namespace
}  // namespace rebound
