#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "fem/implicit/active_set.hpp"
#include "fem/implicit/body_forces.hpp"

namespace rebound::fem {

/// What Newton's method is to bring to zero, and what holds beside it.
struct EquilibriumTask {
  /// Residual at u, and its derivative.
  std::function<BodyForces::Outcome(const Eigen::VectorXd& u, Eigen::VectorXd& residual,
                                    SystemMatrix& matrix)>
      linearise;
  double force_scale = 0.0;  ///< residuals are small against this [N]
  double rounding = 0.0;     ///< what rounding leaves of a residual [N]
  ConstrainedSolver::Given prescribed{};
  /// A load of known direction and unknown size F, and what F works on:
  /// residual + F · load = 0 with load · u = travel. Empty: none.
  Eigen::VectorXd load{};
  double travel = 0.0;
  /// Without inertia and without a plate that holds it, a body is nowhere.
  bool needs_contact = false;
};

/// Newton's method with a sparse direct solve, on a system whose contact nodes
/// are held or free. Ends when the residual of the free unknowns is below 1e-9
/// of the scale (or is rounding) and the active set stands still.
class EquilibriumSearch {
 public:
  /// `like`: a matrix of the body.
  EquilibriumSearch(const QuadraticBody& body, const SystemMatrix& like);

  struct Result {
    bool converged = false;
    bool contact_lost = false;  ///< the task needs a contact, and no node is held
    int iterations = 0;
    double load_size = 0.0;  ///< F of the task's load [N]
    std::string failure;
  };
  /// Changes u and the active set; `reaction` is what holds them [N].
  Result solve(const EquilibriumTask& task, Eigen::VectorXd& u, ActiveSet& held,
               Eigen::VectorXd& reaction);

 private:
  void fix(const EquilibriumTask& task, const Eigen::VectorXd& u, const ActiveSet& held);
  double free_norm() const;
  double largest_miss() const;
  bool solve_change(const EquilibriumTask& task, const Eigen::VectorXd& u, Result& result);

  std::vector<int> axis_nodes_;
  double reach_;
  SystemMatrix matrix_;
  ConstrainedSolver solver_;
  ConstrainedSolver::Given fixed_;  ///< changes that are known
  Eigen::VectorXd residual_, change_;
};

}  // namespace rebound::fem
