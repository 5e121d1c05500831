#include "comparisons/discrepancy/trials/generator/baseline_pulse.hpp"

#include <algorithm>
#include <cmath>

namespace trials {
namespace {

constexpr double step = 0.005;  // contact takes 3 to 4

double power_15(double x) {
  return x > 0.0 ? x * std::sqrt(x) : 0.0;
}

struct Point {
  double x, v;
};

Point rate(const Point& p, double alpha) {
  return {p.v, -power_15(p.x) * (1.0 + alpha * p.v)};
}

Point moved(const Point& p, const Point& by, double h) {
  return {p.x + h * by.x, p.v + h * by.v};
}

Point next(const Point& p, double alpha, double h) {
  const Point a = rate(p, alpha), b = rate(moved(p, a, 0.5 * h), alpha),
              c = rate(moved(p, b, 0.5 * h), alpha), d = rate(moved(p, c, h), alpha);
  return {p.x + h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x),
          p.v + h / 6.0 * (a.v + 2.0 * b.v + 2.0 * c.v + d.v)};
}

}  // namespace

BaselinePulse::BaselinePulse(double alpha) {
  Point p{0.0, 1.0};
  while (true) {
    const double acceleration = rate(p, alpha).v;
    force_.push_back(-acceleration);
    slope_.push_back(1.5 * std::sqrt(std::max(0.0, p.x)) * p.v * (1.0 + alpha * p.v) +
                     power_15(p.x) * alpha * acceleration);
    peak_force_ = std::max(peak_force_, -acceleration);
    peak_deflection_ = std::max(peak_deflection_, p.x);
    if (p.x <= 0.0 && p.v < 0.0) break;
    p = next(p, alpha, step);
  }
  restitution_ = -p.v;
  end_ = static_cast<double>(force_.size() - 1) * step - p.x / p.v;
}

double BaselinePulse::force(double tau) const {
  const double place = tau / step;
  if (place <= 0.0 || place >= static_cast<double>(force_.size() - 1)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  const double s = place - static_cast<double>(i), r = 1.0 - s;
  return r * r * (1.0 + 2.0 * s) * force_[i] + s * s * (1.0 + 2.0 * r) * force_[i + 1] +
         step * s * r * (r * slope_[i] - s * slope_[i + 1]);
}

double BaselinePulse::slope(double tau) const {
  const double place = tau / step;
  if (place <= 0.0 || place >= static_cast<double>(force_.size() - 1)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  const double s = place - static_cast<double>(i);
  return (1.0 - s) * slope_[i] + s * slope_[i + 1];
}

PulseScales scales_of(const BaselineBall& ball, double speed) {
  const double length = std::pow(ball.mass * speed * speed / ball.stiffness, 0.4);
  return {length, length / speed, ball.mass * speed * speed / length};
}

double alpha_of_restitution(double e) {
  const auto excess = [e](double p) { return p * (1.0 + e) - std::log((1.0 + p) / (1.0 - p * e)); };
  double low = 1e-9, high = (1.0 - 1e-12) / e;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

}  // namespace trials
