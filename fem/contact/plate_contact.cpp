#include "fem/contact/plate_contact.hpp"

#include <algorithm>
#include <limits>

namespace rebound::fem {

PlateContact::PlateContact(const Discretisation& body) {
  for (const int node : body.contact_nodes)
    nodes_.push_back({node, body.position[node][0], body.position[node][1], body.mass[node]});
  velocity_before_.resize(nodes_.size());
}

void PlateContact::remember(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    velocity_before_[i] = velocity[2 * nodes_[i].node + 1];
}

double PlateContact::gap(const std::vector<double>& displacement) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& contact : nodes_)
    smallest = std::min(smallest, contact.z + displacement[2 * contact.node + 1]);
  return smallest;
}

}  // namespace rebound::fem
