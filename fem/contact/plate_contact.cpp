#include "fem/contact/plate_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound::fem {

PlateContact::PlateContact(const Discretisation& body, double friction) : friction_(friction) {
  for (const int node : body.contact_nodes)
    nodes_.push_back({node, body.position[node][0], body.position[node][1], body.mass[node]});
  velocity_before_.resize(nodes_.size());
  radial_before_.resize(nodes_.size());
}

void PlateContact::remember(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    radial_before_[i] = velocity[2 * nodes_[i].node];
    velocity_before_[i] = velocity[2 * nodes_[i].node + 1];
  }
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
