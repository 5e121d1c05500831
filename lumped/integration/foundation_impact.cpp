#include "lumped/integration/foundation_impact.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

ViscoelasticFoundation::ViscoelasticFoundation(const StandardLinearSphere& sphere,
                                               double largest_approach, int springs)
    : sphere_(sphere), modulus_(0.75 * sphere.stiffness / std::sqrt(sphere.radius)) {
  // Half a foundation, out to the largest contact radius of h = x²/R.
  const double reach = std::sqrt(sphere.radius * largest_approach);
  spacing_ = reach / springs;
  springs_.resize(static_cast<std::size_t>(springs));
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) * spacing_;
    springs_[i].gap = x * x / sphere.radius;
  }
}

double ViscoelasticFoundation::advance(double approach, double dt) {
  const double decay = std::exp(-dt / sphere_.relaxation_time);
  double sum = 0.0;
  for (Spring& spring : springs_) {
    if (spring.gone) continue;
    const double u = approach - spring.gap;
    if (!spring.touched && u <= 0.0) break;  // those further out are not reached either
    // A spring met within the step moves from zero over its part of the step.
    const double from = spring.touched ? spring.u : 0.0;
    const double part = spring.touched ? 1.0 : u / (approach - approach_);
    const double own = part == 1.0 ? decay : std::exp(-part * dt / sphere_.relaxation_time);
    const double rate = (u - from) / (part * dt);
    spring.q = spring.q * own + rate * sphere_.relaxation_time * (1.0 - own);
    spring.u = u;
    spring.touched = true;
    const double force = u + sphere_.ratio * spring.q;
    if (force <= 0.0)
      spring.gone = true;
    else
      sum += force;
  }
  approach_ = approach;
  return 2.0 * modulus_ * spacing_ * sum;
}

FoundationImpact foundation_impact(const StandardLinearSphere& sphere, const Approach& approach,
                                   int steps_per_contact) {
  const ElasticImpact slow =
      elastic_impact({.stiffness = sphere.stiffness, .damping = 0.0}, approach);
  const ElasticImpact fast = elastic_impact(
      {.stiffness = sphere.stiffness * (1.0 + sphere.ratio), .damping = 0.0}, approach);
  ViscoelasticFoundation foundation(sphere, 1.02 * slow.peak_deflection);
  const double dt = fast.contact_time / steps_per_contact;
  double h = 0.0, v = approach.speed, force = 0.0;
  FoundationImpact impact;
  for (int step = 1; step < 20 * steps_per_contact; ++step) {
    // Velocity Verlet: the force follows from the path alone.
    const double next = h + dt * v - 0.5 * dt * dt * force / approach.mass;
    const double last = force;
    force = foundation.advance(next, dt);
    v -= 0.5 * dt * (force + last) / approach.mass;
    h = next;
    impact.peak_force = std::max(impact.peak_force, force);
    impact.peak_deflection = std::max(impact.peak_deflection, h);
    if (step > 2 && force <= 0.0) {
      impact.restitution = -v / approach.speed;
      impact.contact_time = (step - 0.5) * dt;
      impact.end_deflection = h;
      return impact;
    }
  }
  throw Error(ExitCode::solver_failed, "the contact on the foundation does not end");
}

}  // namespace rebound
