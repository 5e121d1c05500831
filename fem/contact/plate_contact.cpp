#include "fem/contact/plate_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound::fem {

PlateContact::PlateContact(const Discretisation& body, const PlateSurface& surface)
    : friction_(surface.friction) {
  for (const int node : body.contact_nodes)
    nodes_.push_back({node, body.position[node][0], body.position[node][1], body.mass[node]});
  velocity_before_.resize(nodes_.size());
  radial_before_.resize(nodes_.size());
  if (!surface.adhesion.acts()) return;
  adhesion_.emplace(body, surface.adhesion);
  potential_at_rest_ = potential(std::vector<double>(2 * body.position.size(), 0.0), 0.0);
}

void PlateContact::remember(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    radial_before_[i] = velocity[2 * nodes_[i].node];
    velocity_before_[i] = velocity[2 * nodes_[i].node + 1];
  }
}

double PlateContact::attract(const std::vector<double>& displacement, double plate,
                             const StepSpan& span, std::vector<double>& velocity) const {
  double impulse = 0.0;
  if (!adhesion_) return impulse;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ContactNode& contact = nodes_[i];
    const double gap = contact.z + displacement[2 * contact.node + 1] + plate;
    const double pull = span.kick * adhesion_->pull(i, gap);
    velocity[2 * contact.node + 1] -= pull / contact.mass;
    impulse += pull;
  }
  return impulse;
}

double PlateContact::potential(const std::vector<double>& displacement, double plate) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sum += adhesion_->potential(i, nodes_[i].z + displacement[2 * nodes_[i].node + 1] + plate);
  return sum;
}

double PlateContact::adhesive_energy(const std::vector<double>& displacement) const {
  return adhesion_ ? potential(displacement, state().displacement) - potential_at_rest_ : 0.0;
}

void PlateContact::rub(std::size_t i, double impulse, std::vector<double>& velocity,
                       PlateStep& step) const {
  if (friction_ == 0.0) return;
  double& v = velocity[2 * nodes_[i].node];
  const double to_stop = nodes_[i].mass * std::abs(v);
  const double tangential = -std::copysign(std::min(to_stop, friction_ * impulse), v);
  v += tangential / nodes_[i].mass;
  step.friction_work += 0.5 * tangential * (radial_before_[i] + v);
}

double PlateContact::gap(const std::vector<double>& displacement) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& contact : nodes_)
    smallest = std::min(smallest, contact.z + displacement[2 * contact.node + 1]);
  return smallest;
}

}  // namespace rebound::fem
