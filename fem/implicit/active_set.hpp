#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/implicit/quadratic_body.hpp"

namespace rebound::fem {

/// Which contact nodes lie on the rigid plate z = 0: the active set.
///
///   held:  z = 0, λ ≥ 0         free:  z ≥ 0, λ = 0
///
///   z   height of the node [m]      λ   force of the plate on it, upwards [N]
///
/// enforced exactly: no penalty, no smoothing. A node is held when it would
/// penetrate and set free when the plate would have to pull.
class ActiveSet {
 public:
  explicit ActiveSet(const QuadraticBody& body);

  enum class Revision { none, changed };
  /// Holds what penetrates.
  Revision hold(const Eigen::VectorXd& u);
  /// Frees what is pulled; `reaction` is the force on every unknown.
  Revision release(const Eigen::VectorXd& reaction);

  /// Calls `use(unknown, change that puts the node on the plate)` for every held node.
  template <class Use>
  void each_held(const Eigen::VectorXd& u, const Use& use) const {
    for (const Node& node : nodes_)
      if (node.held) use(node.unknown, -(node.height + u[node.unknown]));
  }

  bool any() const;
  double gap(const Eigen::VectorXd& u) const;             ///< smallest height [m]
  double contact_radius(const Eigen::VectorXd& u) const;  ///< of the outermost held node [m]

 private:
  struct Node {
    int unknown = 0;      ///< of its u_z
    double radius = 0.0;  ///< at rest [m]
    double height = 0.0;  ///< at rest [m]
    bool held = false;
  };
  std::vector<Node> nodes_;
  double tolerance_ = 0.0;  ///< of the height [m]
};

}  // namespace rebound::fem
