#include "comparisons/models/instrument/butterworth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Amplitude of a filtered sine once the start has died away.
double gain_at(double frequency, const Butterworth::Design& design) {
  std::vector<double> signal;
  for (int i = 0; i < 40000; ++i)
    signal.push_back(std::sin(2.0 * std::numbers::pi * frequency * i / design.sampling_rate));
  const std::vector<double> passed = Butterworth(design).filter(signal);
  double largest = 0.0;
  for (std::size_t i = 20000; i < passed.size(); ++i)
    largest = std::max(largest, std::abs(passed[i]));
  return largest;
}

TEST(ButterworthTest, HalfPowerAtTheCorner) {
  const Butterworth::Design design{.corner = 5e3, .sampling_rate = 1e6};
  EXPECT_NEAR(gain_at(5e3, design), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(gain_at(10e3, design), 1.0 / std::sqrt(1.0 + std::pow(2.0, 8)), 1e-3);
  EXPECT_NEAR(gain_at(500.0, design), 1.0, 1e-3);
}

TEST(ButterworthTest, KeepsTheImpulse) {
  std::vector<double> pulse(5000, 0.0);
  for (int i = 100; i < 300; ++i) pulse[static_cast<std::size_t>(i)] = 1.0;
  double sum = 0.0;
  for (const double value : Butterworth({.corner = 2e3, .sampling_rate = 2e5}).filter(pulse))
    sum += value;
  EXPECT_NEAR(sum, 200.0, 1e-9);
}

TEST(ButterworthTest, ACornerAboveHalfTheRateIsRefused) {
  EXPECT_THROW(Butterworth({.corner = 6e4, .sampling_rate = 1e5}), Error);
  EXPECT_THROW(Butterworth({.corner = 0.0, .sampling_rate = 1e5}), Error);
}

}  // namespace
}  // namespace rebound
