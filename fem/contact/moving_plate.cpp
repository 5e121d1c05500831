#include "fem/contact/moving_plate.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {

MovingPlate::MovingPlate(const Discretisation& body, const Plate& plate,
                         const AdhesiveTraction& adhesion)
    : PlateContact(body, {.friction = plate.friction, .adhesion = adhesion}),
      mass_(plate.mass),
      stiffness_(plate.stiffness),
      damping_(2.0 * plate.damping_ratio * std::sqrt(plate.stiffness * plate.mass)) {}

double MovingPlate::solve_velocity(const std::vector<double>& displacement, double pull,
                                   const std::vector<double>& velocity,
                                   const StepSpan& span) const {
  const double drift_before = 2.0 * span.kick - span.drift;
  const double quarter = 0.25 * span.kick * stiffness_;
  const double half_damping = 0.5 * span.kick * damping_;
  const double inertia = mass_ + quarter * span.drift + half_damping;
  const double momentum = velocity_ * (mass_ + quarter * drift_before - half_damping) -
                          span.kick * stiffness_ * displacement_ - pull;
  double plate = momentum / inertia;
  for (std::size_t round = 0; round <= nodes_.size(); ++round) {
    double caught_mass = inertia, caught_momentum = momentum;
    for (const ContactNode& contact : nodes_) {
      const double height = contact.z + displacement[2 * contact.node + 1] + displacement_;
      const double wanted = -height / span.drift - velocity[2 * contact.node + 1];
      if (!(wanted > plate)) continue;
      caught_mass += contact.mass;
      caught_momentum += contact.mass * wanted;
    }
    const double next = caught_momentum / caught_mass;
    // From the left without overshoot: no progress is the root, up to rounding.
    if (!(next > plate)) break;
    plate = next;
  }
  return plate;
}

PlateStep MovingPlate::apply_contact(const std::vector<double>& displacement,
                                     std::vector<double>& velocity, const StepSpan& span) {
  PlateStep step;
  velocity_before_step_ = velocity_;
  step.pull = attract(displacement, displacement_, span, velocity);
  velocity_ = solve_velocity(displacement, step.pull, velocity, span);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ContactNode& contact = nodes_[i];
    const double height = contact.z + displacement[2 * contact.node + 1] + displacement_;
    double& v = velocity[2 * contact.node + 1];
    const double held = -height / span.drift - velocity_;
    if (!(held > v)) continue;
    const double impulse = contact.mass * (held - v);
    step.impulse += impulse;
    step.constraint_work += 0.5 * impulse * (velocity_before_[i] + held);
    step.contact_radius = std::max(step.contact_radius, contact.r + displacement[2 * contact.node]);
    v = held;
    rub(i, impulse, velocity, step);
  }
  const double mean_velocity = 0.5 * (velocity_before_step_ + velocity_);
  step.constraint_work += step.impulse * mean_velocity;
  middle_before_ = displacement_ - 0.5 * (2.0 * span.kick - span.drift) * velocity_before_step_;
  middle_after_ = displacement_ + 0.5 * span.drift * velocity_;
  damper_last_ = span.kick * damping_ * mean_velocity * mean_velocity;
  damper_ += damper_last_;
  step.reading =
      span.kick * (stiffness_ * 0.5 * (middle_before_ + middle_after_) + damping_ * mean_velocity);
  return step;
}

PlateState MovingPlate::state() const {
  return {.displacement = displacement_,
          .velocity = velocity_,
          .kinetic = 0.25 * mass_ *
                     (velocity_before_step_ * velocity_before_step_ + velocity_ * velocity_),
          .spring =
              0.25 * stiffness_ * (middle_before_ * middle_before_ + middle_after_ * middle_after_),
          .damper = damper_ - 0.5 * damper_last_};
}

bool MovingPlate::is_clear_of(const std::vector<double>& displacement,
                              const Departure& body) const {
  return is_out_of_reach({.mass = mass_,
                          .stiffness = stiffness_,
                          .damping = damping_,
                          .displacement = displacement_,
                          .velocity = velocity_},
                         gap(displacement), body);
}

}  // namespace rebound::fem
