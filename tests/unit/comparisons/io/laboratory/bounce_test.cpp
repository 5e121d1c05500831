#include "comparisons/io/laboratory/bounce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

constexpr Sphere tennis{.mass = 57.7e-3, .diameter = 66.9e-3};
constexpr Air air{.density = 1.2, .drag_coefficient = 0.55};
constexpr double g = free_fall_acceleration;

TEST(BounceTest, WithoutAirItIsTextbook) {
  const FreeFall fall;
  EXPECT_DOUBLE_EQ(fall.landing_speed(2.54), std::sqrt(2 * g * 2.54));
  EXPECT_DOUBLE_EQ(fall.launch_speed(1.4), std::sqrt(2 * g * 1.4));
  EXPECT_DOUBLE_EQ(fall.launch_speed_for(0.8), 0.4 * g);
  EXPECT_DOUBLE_EQ(fall.flight_time(0.4 * g), 0.8);
}

TEST(BounceTest, ThinAirIsNone) {
  const FreeFall thin(tennis, {.density = 1e-9, .drag_coefficient = 0.5}), none;
  EXPECT_NEAR(thin.landing_speed(2.54), none.landing_speed(2.54), 1e-8);
  EXPECT_NEAR(thin.launch_speed(2.54), none.launch_speed(2.54), 1e-8);
  EXPECT_NEAR(thin.flight_time(5.0), none.flight_time(5.0), 1e-8);
  EXPECT_NEAR(thin.height_reached(5.0), none.height_reached(5.0), 1e-8);
}

/// Up and down, by the equation of motion in steps of 10 us (midpoint rule).
TEST(BounceTest, FallIsThatOfTheEquationOfMotion) {
  const double drag = 0.5 * air.density * air.drag_coefficient * std::numbers::pi / 4.0 *
                      tennis.diameter * tennis.diameter / tennis.mass;
  const double step = 1e-5;
  double height = 0.0, speed = 6.0, time = 0.0, highest = 0.0;
  while (height >= 0.0) {
    const auto rate = [&](double v) { return -g - drag * v * std::abs(v); };
    const double middle = speed + 0.5 * step * rate(speed);
    height += step * middle;
    speed += step * rate(middle);
    time += step;
    highest = std::fmax(highest, height);
  }
  const FreeFall fall(tennis, air);
  EXPECT_NEAR(fall.height_reached(6.0), highest, 1e-6);
  EXPECT_NEAR(fall.launch_speed(highest), 6.0, 1e-5);
  EXPECT_NEAR(fall.flight_time(6.0), time, 2e-5);
  EXPECT_NEAR(fall.landing_speed(highest), -speed, 2e-4);
  EXPECT_NEAR(fall.launch_speed_for(fall.flight_time(6.0)), 6.0, 1e-10);
}

}  // namespace
}  // namespace rebound
