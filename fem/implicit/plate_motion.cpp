#include "fem/implicit/plate_motion.hpp"

#include <cmath>

namespace rebound::fem {

PlateMotion::PlateMotion(const Plate& plate)
    : mass_(plate.mass),
      stiffness_(plate.stiffness),
      damping_(2.0 * plate.damping_ratio * std::sqrt(plate.stiffness * plate.mass)) {}

EquilibriumTask::PlateBalance PlateMotion::balance(double step, const TimeWeights& weights) const {
  const double later = 1.0 - weights.force, per_change = 1.0 / (weights.beta * step * step);
  // a₁ = per_change y₁ + a, v₁ = γ Δt per_change y₁ + v
  const double a = -per_change * (y_ + step * v_) - (0.5 / weights.beta - 1.0) * a_;
  const double v = v_ + step * ((1.0 - weights.gamma) * a_ + weights.gamma * a);
  return {.stiffness = (1.0 - weights.mass) * mass_ * per_change / later +
                       damping_ * weights.gamma * step * per_change + stiffness_,
          .load = mass_ * ((1.0 - weights.mass) * a + weights.mass * a_) / later + damping_ * v +
                  weights.force / later * (damping_ * v_ + stiffness_ * y_ - force_)};
}

void PlateMotion::accept(double step, const TimeWeights& weights, double displacement,
                         double force) {
  const double a = (displacement - y_ - step * v_) / (weights.beta * step * step) -
                   (0.5 / weights.beta - 1.0) * a_;
  const double v = v_ + step * ((1.0 - weights.gamma) * a_ + weights.gamma * a);
  damper_ += 0.5 * step * damping_ * (v_ * v_ + v * v);
  y_ = displacement;
  v_ = v;
  a_ = a;
  force_ = force;
}

}  // namespace rebound::fem
