#include "fem/implicit/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound::fem {
namespace {

/// A node that keeps changing between stick and slide within one step then sticks.
constexpr int most_revisions = 12;

}  // namespace

ActiveSet::ActiveSet(const QuadraticBody& body, double friction)
    : tolerance_(1e-13 * body.height), friction_(friction) {
  for (const ContactPlace& place : body.contact)
    nodes_.push_back({.unknown = 2 * place.node + 1,
                      .radius = body.position[place.node][0],
                      .height = body.position[place.node][1]});
}

void ActiveSet::begin_step(const Eigen::VectorXd& u) {
  if (friction_ == 0.0) return;
  for (Node& node : nodes_) {
    const bool rubbed = node.rubs;
    node.rubs = node.held && node.radius > tolerance_;
    if (!rubbed) node.direction = 0;
    node.start = u[node.unknown - 1];
    node.revisions = 0;
  }
}

ActiveSet::Revision ActiveSet::hold(const Eigen::VectorXd& u) {
  Revision revision = Revision::none;
  for (Node& node : nodes_)
    if (!node.held && node.height + plate_ + u[node.unknown] < -tolerance_) {
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

void ActiveSet::rub(Eigen::VectorXd& residual, SystemMatrix& matrix) const {
  if (friction_ == 0.0) return;
  for (const Node& node : nodes_) {
    const double push = residual[node.unknown];
    if (!node.held || !node.rubs || node.direction == 0 || push <= 0.0) continue;
    residual[node.unknown - 1] -= node.direction * friction_ * push;
    matrix.add_row(node.unknown - 1, -node.direction * friction_, node.unknown);
  }
}

ActiveSet::Revision ActiveSet::slide(const Eigen::VectorXd& residual, const Eigen::VectorXd& u) {
  Revision revision = Revision::none;
  if (friction_ == 0.0) return revision;
  for (Node& node : nodes_) {
    if (!node.held || !node.rubs || node.revisions > most_revisions) continue;
    const double cone = friction_ * std::max(0.0, residual[node.unknown]);
    const double tangential = residual[node.unknown - 1], moved = u[node.unknown - 1] - node.start;
    int direction = node.direction;
    if (direction == 0 && std::abs(tangential) > (1.0 + 1e-9) * cone)
      direction = tangential > 0.0 ? 1 : -1;
    else if (direction * moved > tolerance_)
      direction = 0;
    if (direction == node.direction) continue;
    node.direction = ++node.revisions > most_revisions ? 0 : direction;
    revision = Revision::changed;
  }
  return revision;
}

void ActiveSet::add_reactions(const Eigen::VectorXd& residual, Eigen::VectorXd& reaction) const {
  for (const Node& node : nodes_) {
    if (!node.held) continue;
    const double push = residual[node.unknown];
    reaction[node.unknown] = push;
    if (!node.rubs) continue;
    reaction[node.unknown - 1] = node.direction == 0
                                     ? residual[node.unknown - 1]
                                     : node.direction * friction_ * std::max(0.0, push);
  }
}

double ActiveSet::push(const Eigen::VectorXd& reaction) const {
  double sum = 0.0;
  for (const Node& node : nodes_)
    if (node.held) sum += reaction[node.unknown];
  return sum;
}

bool ActiveSet::any() const {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.held; });
}

double ActiveSet::gap(const Eigen::VectorXd& u) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_)
    smallest = std::min(smallest, node.height + plate_ + u[node.unknown]);
  return smallest;
}

double ActiveSet::contact_radius(const Eigen::VectorXd& u) const {
  double largest = 0.0;
  for (const Node& node : nodes_)
    if (node.held) largest = std::max(largest, node.radius + u[node.unknown - 1]);
  return largest;
}

}  // namespace rebound::fem
