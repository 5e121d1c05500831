#include "fem/impact/window_scalars.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound::fem {
namespace {

/// A Hertz-like pulse (sin π t)^(3/2) of peak 1 and duration 1, as even impulses.
ImpulseBins pulse(double interval, int steps = 20000, double ripple = 0.0) {
  ImpulseBins bins(interval, 100);
  const double step = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = step * (i + 0.5);
    const double force =
        std::pow(std::sin(M_PI * t), 1.5) * (1.0 + ripple * std::sin(200.0 * M_PI * t));
    bins.add(step * force, step * i, step * (i + 1));
  }
  return bins;
}

TEST(WindowScalarsTest, PulseOfKnownScalars) {
  const WindowScalars found = window_scalars(pulse(0.5 / windows_per_contact), 1.0);
  // The mean over a window is below the peak by (window)²/24 times the curvature 3π²/2.
  const double below = 1.5 * M_PI * M_PI / (24.0 * windows_per_contact * windows_per_contact);
  EXPECT_NEAR(found.peak_force, 1.0 - below, 1e-6);
  EXPECT_NEAR(found.contact_time_1pct, 1.0 - 2.0 * std::asin(std::pow(0.01, 2.0 / 3.0)) / M_PI,
              1e-3);
  // sin^(3/2) is not quite a Hertz tail: its F^(2/3) bends down by an eighth of its angle squared.
  EXPECT_NEAR(found.contact_time_tail, 1.0, 3e-3);
}

TEST(WindowScalarsTest, RippleShorterThanTheWindowHardlyMovesThePeak) {
  const double smooth = window_scalars(pulse(0.5 / windows_per_contact), 1.0).peak_force;
  const double rippled =
      window_scalars(pulse(0.5 / windows_per_contact, 20000, 0.05), 1.0).peak_force;
  EXPECT_LT(rippled - smooth, 0.01);
}

TEST(WindowScalarsTest, TailOfHertzIsExact) {
  std::vector<double> time, force;
  for (int i = 0; i <= 60; ++i) {
    time.push_back(0.01 * i);
    force.push_back(std::pow(std::max(0.0, 0.57 - 0.01 * i), 1.5));
  }
  EXPECT_NEAR(tail_contact_time(time, force, force.front(), 9.0), 0.57, 1e-12);
}

TEST(WindowScalarsTest, TailRestsOnFifteenToTwoPerCent) {
  std::vector<double> time, force;
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.01 * i, f = std::pow(std::max(0.0, 1.0 - t), 1.5);
    time.push_back(t);
    force.push_back(f > 0.151    ? 1.3 * f
                    : f < 0.0199 ? 0.5 * f
                                 : f);  // elsewhere it may be anything
  }
  EXPECT_NEAR(tail_contact_time(time, force, 1.0, 9.0), 1.0, 1e-12);
}

TEST(WindowScalarsTest, AFlatEndHasNoTail) {
  const std::vector<double> time{0, 1, 2, 3, 4}, force{0, 1, 1, 1, 0};
  EXPECT_EQ(tail_contact_time(time, force, 1.0, 3.5), 3.5);
}

}  // namespace
}  // namespace rebound::fem
