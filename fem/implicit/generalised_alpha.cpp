#include "fem/implicit/generalised_alpha.hpp"

namespace rebound::fem {

GeneralisedAlpha::StepTerms GeneralisedAlpha::terms(double step, const MotionState& now,
                                                    const BodyForces& forces,
                                                    double gravity) const {
  const double per_change = 1.0 / (weights_.beta * step * step);
  const Eigen::VectorXd carried = (1.0 - weights_.mass) * (per_change * (now.u + step * now.v) +
                                                           (0.5 / weights_.beta - 1.0) * now.a) -
                                  weights_.mass * now.a;
  const Eigen::VectorXd fixed_part =
      (weights_.force / (1.0 - weights_.force)) * (now.force - now.reaction) -
      forces.mass().times(carried) / (1.0 - weights_.force);
  const double weight = gravity / (1.0 - weights_.force);
  return {.fixed = fixed_part + weight * forces.axial_mass(),
          .inertia = (1.0 - weights_.mass) * per_change / (1.0 - weights_.force)};
}

Eigen::VectorXd GeneralisedAlpha::ahead(double step, const MotionState& now,
                                        const Eigen::VectorXd& last_change) const {
  Eigen::VectorXd u = now.u + step * now.v + (0.5 * step * step) * now.a;
  for (const int unknown : massless_) u[unknown] = now.u[unknown] + last_change[unknown];
  return u;
}

void GeneralisedAlpha::complete(double step, const MotionState& now, MotionState& next) const {
  next.a = (next.u - now.u - step * now.v) / (weights_.beta * step * step) -
           (0.5 / weights_.beta - 1.0) * now.a;
  next.v = now.v + step * ((1.0 - weights_.gamma) * now.a + weights_.gamma * next.a);
  for (const int unknown : massless_) {
    next.a[unknown] = 0.0;
    next.v[unknown] = (next.u[unknown] - now.u[unknown]) / step;
  }
  next.time = now.time + step;
}

}  // namespace rebound::fem
