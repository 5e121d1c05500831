#include "fem/contact/rigid_plate.hpp"

#include <algorithm>
#include <limits>

namespace rebound::fem {

RigidPlate::RigidPlate(const Discretisation& body) {
  for (const int node : body.contact_nodes)
    nodes_.push_back({node, body.position[node][0], body.position[node][1], body.mass[node]});
  velocity_before_.resize(nodes_.size());
}

void RigidPlate::remember(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    velocity_before_[i] = velocity[2 * nodes_[i].node + 1];
}

PlateStep RigidPlate::hold_back(const std::vector<double>& displacement,
                                std::vector<double>& velocity, const StepSpan& span) const {
  PlateStep step;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ContactNode& contact = nodes_[i];
    const double z = contact.z + displacement[2 * contact.node + 1];
    double& v = velocity[2 * contact.node + 1];
    if (z + span.drift * v >= 0.0) continue;
    const double held = -z / span.drift;
    const double impulse = contact.mass * (held - v);
    step.impulse += impulse;
    step.constraint_work += 0.5 * impulse * (velocity_before_[i] + held);
    step.contact_radius =
        std::max(step.contact_radius, contact.r + displacement[2 * contact.node]);
    v = held;
  }
  return step;
}

double RigidPlate::gap(const std::vector<double>& displacement) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& contact : nodes_)
    smallest = std::min(smallest, contact.z + displacement[2 * contact.node + 1]);
  return smallest;
}

}  // namespace rebound::fem
