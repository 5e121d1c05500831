#include "fem/contact/rigid_plate.hpp"

#include <algorithm>

namespace rebound::fem {

PlateStep RigidPlate::apply_contact(const std::vector<double>& displacement,
                                    std::vector<double>& velocity, const StepSpan& span) {
  PlateStep step;
  step.pull = attract(displacement, 0.0, span, velocity);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ContactNode& contact = nodes_[i];
    const double z = contact.z + displacement[2 * contact.node + 1];
    double& v = velocity[2 * contact.node + 1];
    if (z + span.drift * v >= 0.0) continue;
    const double held = -z / span.drift;
    const double impulse = contact.mass * (held - v);
    step.impulse += impulse;
    step.constraint_work += 0.5 * impulse * (velocity_before_[i] + held);
    step.contact_radius = std::max(step.contact_radius, contact.r + displacement[2 * contact.node]);
    v = held;
    rub(i, impulse, velocity, step);
  }
  return step;
}

bool RigidPlate::is_clear_of(const std::vector<double>& displacement, const Departure& body) const {
  return body.speed > 0.0 && gap(displacement) > body.vibration;
}

}  // namespace rebound::fem
