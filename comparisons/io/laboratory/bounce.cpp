#include "comparisons/io/laboratory/bounce.hpp"

#include <cmath>
#include <numbers>

namespace rebound {
namespace {

constexpr double g = free_fall_acceleration;

}  // namespace

FreeFall::FreeFall(const Sphere& ball, const Air& air)
    : rate_(air.density * air.drag_coefficient * std::numbers::pi * ball.diameter * ball.diameter /
            (8.0 * ball.mass * g)) {}

double FreeFall::landing_speed(double height) const {
  if (rate_ == 0.0) return std::sqrt(2.0 * g * height);
  return std::sqrt(-std::expm1(-2.0 * g * height * rate_) / rate_);
}

double FreeFall::launch_speed(double height) const {
  if (rate_ == 0.0) return std::sqrt(2.0 * g * height);
  return std::sqrt(std::expm1(2.0 * g * height * rate_) / rate_);
}

double FreeFall::height_reached(double speed) const {
  if (rate_ == 0.0) return speed * speed / (2.0 * g);
  return std::log1p(speed * speed * rate_) / (2.0 * g * rate_);
}

double FreeFall::flight_time(double speed) const {
  if (rate_ == 0.0) return 2.0 * speed / g;
  // Up: (w/g) atan(v/w); down from h: (w/g) arcosh(exp(g h/w²)) = (w/g) arsinh(v/w).
  const double root = std::sqrt(rate_);
  return (std::atan(speed * root) + std::asinh(speed * root)) / (g * root);
}

double FreeFall::launch_speed_for(double time) const {
  double speed = 0.5 * g * time;
  if (rate_ == 0.0) return speed;
  // Newton; the flight time is smooth and grows with the speed.
  constexpr int most_steps = 50;
  constexpr double enough = 1e-14;
  const double root = std::sqrt(rate_);
  for (int i = 0; i < most_steps; ++i) {
    const double u = speed * root;
    const double slope = (1.0 / (1.0 + u * u) + 1.0 / std::sqrt(1.0 + u * u)) / g;
    const double step = (flight_time(speed) - time) / slope;
    // Concave in the speed: from below, Newton stays on that side.
    speed = std::fmax(speed - step, 0.5 * speed);
    if (std::fabs(step) < enough * speed) break;
  }
  return speed;
}

}  // namespace rebound
