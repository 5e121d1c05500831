#include "comparisons/discrepancy/trials/generator/measuring_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trials::testing {
namespace {

constexpr Sampling sampling{.rate = 1e6, .first_time = -5e-4, .count = 4000};

/// A half sine of 1000 N that lasts a millisecond.
SimulatedImpact half_sine() {
  SimulatedImpact impact{.start = 0.0, .step = 1e-7, .force = {}};
  for (int i = 0; i <= 10000; ++i)
    impact.force.push_back(1000.0 * std::sin(std::numbers::pi * i / 10000.0));
  return impact;
}

double time_of_peak(const std::vector<double>& force) {
  return sampling.first_time +
         static_cast<double>(std::max_element(force.begin(), force.end()) - force.begin()) /
             sampling.rate;
}

double impulse_of(const std::vector<double>& force) {
  double sum = 0.0;
  for (const double value : force) sum += value / sampling.rate;
  return sum;
}

TEST(TrialChain, ADelayIsLaterAndATimeFactorLonger) {
  const auto reported = [](const MeasuringChain& chain) {
    return reported_force(half_sine(), chain, sampling, 0);
  };
  EXPECT_NEAR(time_of_peak(reported({})), 0.5e-3, 2e-6);
  EXPECT_NEAR(time_of_peak(reported({.delay = 1e-4})), 0.6e-3, 2e-6);
  const std::vector<double> longer = reported({.time_factor = 1.2});
  EXPECT_NEAR(time_of_peak(longer), 0.6e-3, 2e-6);
  EXPECT_NEAR(impulse_of(longer) / impulse_of(reported({})), 1.2, 1e-3);
}

// One pole of a low-pass keeps the impulse and comes later by its time constant.
TEST(TrialChain, APoleKeepsTheImpulseAndComesLater) {
  const double time_constant = 5e-5;
  const MeasuringChain chain{.cut_off = 1.0 / (2.0 * std::numbers::pi * time_constant), .poles = 1};
  const std::vector<double> plain = reported_force(half_sine(), {}, sampling, 0);
  const std::vector<double> filtered = reported_force(half_sine(), chain, sampling, 0);
  EXPECT_NEAR(impulse_of(filtered) / impulse_of(plain), 1.0, 1e-3);
  const auto centre = [](const std::vector<double>& force) {
    double first = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i)
      first += force[i] * static_cast<double>(i) / (sampling.rate * sampling.rate);
    return first / impulse_of(force);
  };
  EXPECT_NEAR(centre(filtered) - centre(plain), time_constant, 1e-6);
}

TEST(TrialChain, GainOffsetDriftAndClippingActInTheirOrder) {
  const MeasuringChain chain{
      .gain = 1.1, .odd_shot = 2, .odd_gain = 0.5, .offset = 3.0, .drift = 1000.0};
  const std::vector<double> usual = reported_force(half_sine(), chain, sampling, 1);
  const std::vector<double> odd = reported_force(half_sine(), chain, sampling, 2);
  EXPECT_NEAR(usual[1000], 1100.0 + 3.0 + 1.0, 1e-3);
  EXPECT_NEAR(odd[1000], 550.0 + 3.0 + 1.0, 1e-3);
  std::vector<double> force{-3.2, 12.6, 70.0};
  digitise({.clip_at = 50.0, .rounding_step = 5.0}, force);
  EXPECT_EQ(force, (std::vector<double>{-5.0, 15.0, 50.0}));
}

}  // namespace
}  // namespace trials::testing
