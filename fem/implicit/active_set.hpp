#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/implicit/quadratic_body.hpp"
#include "fem/implicit/system_matrix.hpp"

namespace rebound::fem {

/// Which contact nodes lie on the rigid plate z = −y: the active set; and which of those stick.
///
///   held:    z = −y, λ ≥ 0           free:   z ≥ −y, λ = 0
///   sticks:  u_r as at the start of the step, |t| ≤ μ λ
///   slides:  t = ±μ λ against the motion of the step
///
///   z   height of the node [m]      λ, t   force of the plate on it, upwards and outwards [N]
///   y   displacement of the plate, away from the ball [m];   μ   friction [-]
///
/// enforced exactly: no penalty, no smoothing. A node is held when it would
/// penetrate and set free when the plate would have to pull. It rubs from the step after the
/// one in which it lands: where it touched within that step is not known.
/// Limit:  μ = 0 leaves every bit; energy closes with what sliding takes
///         -> tests ImplicitImpactTest.MomentumAndEnergy, ImplicitContact
class ActiveSet {
 public:
  explicit ActiveSet(const QuadraticBody& body, double friction = 0.0);

  enum class Revision { none, changed };
  /// A step begins at u: those held now rub in it.
  void begin_step(const Eigen::VectorXd& u);
  /// Holds what penetrates.
  Revision hold(const Eigen::VectorXd& u);
  /// Frees what is pulled; `reaction` is the force on every unknown.
  Revision release(const Eigen::VectorXd& reaction);
  /// Adds the friction of sliding nodes to the residual and to its derivative.
  void rub(Eigen::VectorXd& residual, SystemMatrix& matrix) const;
  /// Lets go what its cone does not hold, and sticks what would slide with its friction.
  Revision slide(const Eigen::VectorXd& residual, const Eigen::VectorXd& u);

  /// Calls `use(unknown, change that puts the node on the plate)` for every held node, and the
  /// same for the u_r of those that stick.
  template <class Use>
  void each_held(const Eigen::VectorXd& u, const Use& use) const {
    for (const Node& node : nodes_) {
      if (!node.held) continue;
      use(node.unknown, -(node.height + plate_ + u[node.unknown]));
      if (node.rubs && node.direction == 0) use(node.unknown - 1, node.start - u[node.unknown - 1]);
    }
  }
  /// Force of the plate on every unknown, from the residual of an equilibrium [N].
  void add_reactions(const Eigen::VectorXd& residual, Eigen::VectorXd& reaction) const;
  /// Σ λ of such forces on the nodes that are held [N].
  double push(const Eigen::VectorXd& reaction) const;

  bool rubs() const { return friction_ > 0.0; }
  bool any() const;
  double gap(const Eigen::VectorXd& u) const;             ///< smallest, to the plate [m]
  double contact_radius(const Eigen::VectorXd& u) const;  ///< of the outermost held node [m]

  double plate() const { return plate_; }  ///< y [m]
  void move_plate(double change) { plate_ += change; }

 private:
  struct Node {
    int unknown = 0;      ///< of its u_z
    double radius = 0.0;  ///< at rest [m]
    double height = 0.0;  ///< at rest [m]
    bool held = false;
    bool rubs = false;
    double start = 0.0;  ///< u_r at the start of the step [m]
    int direction = 0;   ///< of the plate's friction; 0: sticks
    int revisions = 0;   ///< of stick and slide within the step
  };
  std::vector<Node> nodes_;
  double tolerance_ = 0.0;  ///< of the height [m]
  double friction_ = 0.0;   ///< μ [-]
  double plate_ = 0.0;      ///< y [m]
};

}  // namespace rebound::fem
