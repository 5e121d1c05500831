#include "comparisons/models/instrument/lag.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

/// F = a t on samples that are not even.
Trace ramp(double slope, double end) {
  Trace trace;
  for (int i = 0; i <= 60; ++i) {
    const double share = i / 60.0;
    trace.time.push_back(end * share * share);
    trace.force.push_back(slope * trace.time.back());
  }
  return trace;
}

TEST(LagTest, WithoutATimeNothingChanges) {
  const Trace force = ramp(1e5, 2e-3);
  EXPECT_EQ(with_lag(force, 0.0, 5e-3).force, force.force);
}

// τ y' = a t − y: y = a (t − τ + τ e^{−t/τ}).
TEST(LagTest, ARampComesLateByTheTimeConstant) {
  constexpr double slope = 1e5, tau = 3e-4;
  const Trace passed = with_lag(ramp(slope, 2e-3), tau, 0.0);
  for (std::size_t i = 0; i <= 60; ++i) {
    const double t = passed.time[i];
    EXPECT_NEAR(passed.force[i], slope * (t - tau + tau * std::exp(-t / tau)), 1e-9);
  }
}

// ∫ y dt = ∫ F dt: what the sensor is late by comes after the contact.
TEST(LagTest, KeepsTheImpulse) {
  constexpr double slope = 1e5, end = 2e-3, tau = 2e-4;
  const Trace passed = with_lag(ramp(slope, end), tau, end + 20.0 * tau);
  double impulse = 0.0;
  for (std::size_t i = 1; i < passed.time.size(); ++i)
    impulse +=
        0.5 * (passed.force[i] + passed.force[i - 1]) * (passed.time[i] - passed.time[i - 1]);
  EXPECT_NEAR(impulse, 0.5 * slope * end * end, 1e-3 * 0.5 * slope * end * end);
}

// A contact that ends as it begins once made a record of 10⁹ samples.
TEST(LagTest, AShortContactMakesNoEndlessRecord) {
  EXPECT_LT(with_lag(ramp(1e5, 1e-12), 1e-4, 5e-3).time.size(), 20000u);
}

}  // namespace
}  // namespace rebound
