#include "fem/implicit/active_set.hpp"

#include <algorithm>
#include <limits>

namespace rebound::fem {

ActiveSet::ActiveSet(const QuadraticBody& body) : tolerance_(1e-13 * body.height) {
  for (const ContactPlace& place : body.contact)
    nodes_.push_back({.unknown = 2 * place.node + 1,
                      .radius = body.position[place.node][0],
                      .height = body.position[place.node][1]});
}

ActiveSet::Revision ActiveSet::hold(const Eigen::VectorXd& u) {
  Revision revision = Revision::none;
  for (Node& node : nodes_)
    if (!node.held && node.height + u[node.unknown] < -tolerance_) {
      node.held = true;
      revision = Revision::changed;
    }
  return revision;
}

ActiveSet::Revision ActiveSet::release(const Eigen::VectorXd& reaction) {
  double largest = 0.0;
  for (const Node& node : nodes_)
    if (node.held) largest = std::max(largest, std::abs(reaction[node.unknown]));
  Revision revision = Revision::none;
  for (Node& node : nodes_)
    if (node.held && reaction[node.unknown] < -1e-9 * largest) {
      node.held = false;
      revision = Revision::changed;
    }
  return revision;
}

bool ActiveSet::any() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.held; });
}

double ActiveSet::gap(const Eigen::VectorXd& u) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_) smallest = std::min(smallest, node.height + u[node.unknown]);
  return smallest;
}

double ActiveSet::contact_radius(const Eigen::VectorXd& u) const {
  double largest = 0.0;
  for (const Node& node : nodes_)
    if (node.held) largest = std::max(largest, node.radius + u[node.unknown - 1]);
  return largest;
}

}  // namespace rebound::fem
