#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lumped/integration/fast/fast_integrator.hpp"

namespace rebound {

/// Force at one point of the motion and what follows it by each direction.
template <std::size_t Width>
struct ForceWithSensitivities {
  double u, v;  ///< √x and ẋ
  ForceSlopes force;
  std::array<double, Width> du, dv;  ///< δ√x and δẋ, at fixed τ
  std::array<double, Width> dt;      ///< δt, at fixed τ
  std::array<double, Width> by;      ///< ∂F/∂p at fixed x and ẋ

  /// δF at fixed τ, which is all of it where F does not change in time.
  double at_fixed_tau(std::size_t i) const {
    const double by_x = u == 0.0 ? 0.0 : 2.0 * force.by_log_deflection / u * du[i];
    return by_x + force.by_speed * dv[i] + by[i];
  }
  /// dF/dτ.
  double rate(double mass) const {
    const double by_x = u == 0.0 ? 0.0 : 2.0 * force.by_log_deflection / u * v;
    return by_x - force.by_speed * 2.0 * u * force.force / mass;
  }
  /// δF at fixed time: x moves on by −v δt, ẋ by F/m δt.
  double at_fixed_time(std::size_t i, double mass) const {
    if (u == 0.0) return at_fixed_tau(i);
    return at_fixed_tau(i) -
           (force.by_log_deflection / (u * u) * v - force.by_speed * force.force / mass) * dt[i];
  }
  /// δF at fixed x: the point at which x is reached moves by δτ = −δu/v.
  double at_fixed_deflection(std::size_t i, double mass) const {
    const double acceleration = -2.0 * u * force.force / mass;
    return force.by_speed * (dv[i] - acceleration / v * du[i]) + by[i];
  }
};

/// Where within a step an instant lies: Newton on t(τ), whose slope is 2u.
inline double fraction_at(const StepEnd& left, const StepEnd& right, double instant) {
  const Septic clock(left.clock(), right.clock(), left.step);
  const double share = std::clamp((instant - left.t) / (right.t - left.t), 0.0, 1.0);
  // Time runs as a parabola where u passes zero: the square root starts
  // Newton on the side from which it converges.
  double s = left.u < right.u ? std::sqrt(share) : 1.0 - std::sqrt(1.0 - share);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double rate = clock.derivative(s);
    if (!(rate > 0.0)) break;  // at rest in τ: s is the end itself
    const double change = (instant - clock.value(s)) / rate;
    s = std::clamp(s + change, 0.0, 1.0);
    if (std::abs(change) < 1e-12) break;
  }
  return s;
}

/// Motion and its derivatives within one step of the fast integrator: u from its own
/// polynomial, δu and δv as slope and curvature of the one of δt.
///
/// Error: seventh and sixth order in the step.
template <ContactLaw Law, std::size_t Width>
class StepWithSensitivities {
 public:
  using Integrator = FastIntegrator<Law, Width>;

  StepWithSensitivities(const Law& law, const Integrator& run, std::size_t k,
                        const std::array<Direction, Width>& directions)
      : law_(law),
        directions_(directions),
        inverse_(1.0 / run.step_ends()[k].step),
        root_(run.step_ends()[k].root(), run.step_ends()[k + 1].root(), run.step_ends()[k].step) {
    for (std::size_t i = 0; i < Width; ++i)
      clocks_[i] = Septic(run.variations()[k].clock(i), run.variations()[k + 1].clock(i),
                          run.step_ends()[k].step);
  }

  const Septic& root() const { return root_; }

  ForceWithSensitivities<Width> at(double s) const {
    ForceWithSensitivities<Width> point;
    point.u = root_.value(s);
    point.v = root_.derivative(s) * inverse_;
    point.force = law_.at_root(point.u, point.v);
    for (std::size_t i = 0; i < Width; ++i) {
      point.dt[i] = clocks_[i].value(s);
      point.du[i] = 0.5 * inverse_ * clocks_[i].derivative(s);
      point.dv[i] = 0.5 * inverse_ * inverse_ * clocks_[i].second_derivative(s);
      point.by[i] = directions_[i].of == Direction::Of::law
                        ? law_.slope_by(directions_[i].parameter, point.u, point.v)
                        : 0.0;
    }
    return point;
  }

 private:
  const Law& law_;
  std::array<Direction, Width> directions_;
  double inverse_;
  Septic root_;
  std::array<Septic, Width> clocks_;
};

}  // namespace rebound
