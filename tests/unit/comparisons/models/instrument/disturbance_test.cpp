#include "comparisons/models/instrument/disturbance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

TEST(DisturbanceTest, NothingIsAddedByDefault) {
  EXPECT_EQ(added_force({}, 1e-3), 0.0);
  EXPECT_EQ(added_force({.force_baseline = 0.1}, 1e-3), 0.1);
}

TEST(DisturbanceTest, DriftIsALineThroughFirstTouch) {
  const MeasurementChain chain{.force_baseline = 2.0, .force_drift = 1e4};
  EXPECT_EQ(added_force(chain, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(added_force(chain, 1e-3), 12.0);
  EXPECT_DOUBLE_EQ(added_force(chain, -1e-3), -8.0);
}

TEST(DisturbanceTest, HumHasZeroMeanOverAPeriod) {
  const MeasurementChain chain{.hum = {.amplitude = 50.0, .frequency = 400.0, .phase = 0.7}};
  constexpr int count = 64;
  double mean = 0.0, square = 0.0;
  for (int i = 0; i < count; ++i) {
    const double force = added_force(chain, 2.5e-3 * i / count);
    mean += force / count;
    square += force * force / count;
  }
  EXPECT_NEAR(mean, 0.0, 1e-10);
  EXPECT_NEAR(std::sqrt(square), 50.0 / std::sqrt(2.0), 1e-10);
  EXPECT_DOUBLE_EQ(added_force(chain, 0.0), 50.0 * std::sin(0.7));
}

TEST(DisturbanceTest, ABurstStartsAtItsInstantAndDecays) {
  const MeasurementChain chain{
      .burst = {.amplitude = 80.0, .frequency = 2e3, .decay_time = 1e-3, .instant = 0.4e-3}};
  EXPECT_EQ(added_force(chain, 0.3999e-3), 0.0);
  // A quarter of a period later it is at its crest, less what has decayed.
  EXPECT_NEAR(added_force(chain, 0.525e-3), 80.0 * std::exp(-0.125), 1e-9);
  EXPECT_NEAR(added_force(chain, 1.525e-3) / added_force(chain, 0.525e-3), std::exp(-1.0), 1e-9);
}

}  // namespace
}  // namespace rebound
