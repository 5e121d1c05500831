#include "comparisons/discrepancy/diagnosis/believed_fem/carried_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

ModelledImpact half_sine(double peak, double duration, double restitution) {
  ModelledImpact impact;
  for (int i = 0; i <= 100; ++i) {
    const double phase = i / 100.0;
    impact.trace.time.push_back(phase * duration);
    impact.trace.force.push_back(peak * std::sin(std::numbers::pi * phase));
    impact.trace.deflection.push_back(1e-6 * peak * std::sin(std::numbers::pi * phase));
  }
  impact.scalars = {.restitution = restitution,
                    .contact_time = duration,
                    .contact_time_1pct = 0.99 * duration,
                    .peak_force = peak,
                    .peak_deflection = 1e-6 * peak,
                    .mean_deflection = 6e-7 * peak,
                    .rebound_speed = 10.0 * restitution};
  return impact;
}

TEST(CarriedDifferenceTest, MakesTheSecondImpactOfTheFirst) {
  const ModelledImpact first = half_sine(1000.0, 1e-3, 0.7), second = half_sine(1100.0, 9e-4, 0.6);
  ModelledImpact made = first;
  difference_between(first, second).apply(made);
  for (std::size_t i = 0; i < made.trace.time.size(); ++i) {
    EXPECT_NEAR(made.trace.time[i], second.trace.time[i], 1e-15);
    EXPECT_NEAR(made.trace.force[i], second.trace.force[i], 1e-9);
    EXPECT_NEAR(made.trace.deflection[i], second.trace.deflection[i], 1e-15);
  }
  EXPECT_NEAR(made.scalars.restitution, 0.6, 1e-12);
  EXPECT_NEAR(made.scalars.rebound_speed, 6.0, 1e-12);
  EXPECT_NEAR(made.scalars.contact_time, 9e-4, 1e-15);
  EXPECT_NEAR(made.scalars.peak_force, 1100.0, 1e-9);
}

TEST(CarriedDifferenceTest, HalfOfItIsHalfTheWay) {
  const ModelledImpact first = half_sine(1000.0, 1e-3, 0.8), second = half_sine(1210.0, 4e-4, 0.2);
  ModelledImpact made = first;
  difference_between(first, second).apply_times(made, 0.5);
  EXPECT_NEAR(made.trace.force[50], 1105.0, 1e-9);
  EXPECT_NEAR(made.trace.time.back(), std::sqrt(4e-7), 1e-12);
  EXPECT_NEAR(made.scalars.restitution, 0.4, 1e-12);
  EXPECT_NEAR(made.scalars.peak_force, 1100.0, 1e-9);
}

TEST(CarriedDifferenceTest, PowersOfTheSpeedAreMet) {
  const auto at = [](double speed) {
    return half_sine(100.0 * std::pow(speed, 1.2), 1e-3 * std::pow(speed, -0.2),
                     std::pow(speed, -0.15));
  };
  constexpr double speed = 5.0, step = 0.05;
  const KnownDifferences known{.ball = 0,
                               .speed = speed,
                               .finer = {},
                               .faster = difference_between(at(speed), at(speed * (1.0 + step))),
                               .step = step};
  for (const double other : {3.5, 4.9, 5.0, 6.5}) {
    ModelledImpact made = at(speed);
    known.carry_to(made, other);
    const ModelledImpact meant = at(other);
    EXPECT_NEAR(made.scalars.peak_force, meant.scalars.peak_force, 1e-8);
    EXPECT_NEAR(made.scalars.contact_time, meant.scalars.contact_time, 1e-13);
    EXPECT_NEAR(made.scalars.restitution, meant.scalars.restitution, 1e-12);
    EXPECT_NEAR(made.trace.time.back(), meant.trace.time.back(), 1e-13);
  }
}

// At another scale the difference grows with the force.
TEST(CarriedDifferenceTest, GoesWithThePeak) {
  const ModelledImpact first = half_sine(1000.0, 1e-3, 0.7), second = half_sine(1100.0, 1e-3, 0.7);
  ModelledImpact other = half_sine(2000.0, 1e-3, 0.7);
  difference_between(first, second).apply(other);
  EXPECT_NEAR(other.trace.force[50], 2200.0, 1e-9);
}

TEST(CarriedDifferenceTest, HistoryDifferenceIsOverThePeak) {
  const ModelledImpact first = half_sine(1000.0, 1e-3, 0.7), second = half_sine(1010.0, 1e-3, 0.7);
  EXPECT_NEAR(history_difference(first, second), 0.01 * std::sqrt(0.5), 1e-4);
  EXPECT_EQ(history_difference(first, first), 0.0);
}

}  // namespace
}  // namespace rebound
