#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fem/implicit/body_forces.hpp"
#include "fem/implicit/held_nodes.hpp"

namespace rebound::fem {

/// What Newton's method is to bring to zero, and what holds beside it.
struct EquilibriumTask {
  /// Residual at u, and its derivative (lower triangle).
  std::function<BodyForces::Outcome(const Eigen::VectorXd& u, Eigen::VectorXd& residual,
                                    SystemMatrix& matrix)>
      linearise;
  double force_scale = 0.0;  ///< residuals are small against this [N]
  double rounding = 0.0;     ///< what rounding leaves of a residual [N]
  /// Unknowns with given values.
  std::vector<std::pair<int, double>> prescribed{};
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
  EquilibriumSearch(const QuadraticBody& body, const SystemMatrix& pattern);

  struct Result {
    bool converged = false;
    bool contact_lost = false;  ///< the task needs a contact, and no node is held
    int iterations = 0;
    double load_size = 0.0;  ///< F of the task's load [N]
    std::string failure;
  };
  /// Changes u and the active set; `reaction` is what holds them [N].
  Result solve(const EquilibriumTask& task, Eigen::VectorXd& u, HeldNodes& held,
               Eigen::VectorXd& reaction);

  long factorisations() const { return factorisations_; }

 private:
  void mark_fixed(const EquilibriumTask& task, const Eigen::VectorXd& u, const HeldNodes& held);
  double free_norm(const Eigen::VectorXd& residual) const;
  double largest_miss() const;
  bool solve_change(const EquilibriumTask& task, const Eigen::VectorXd& u, Result& result);

  std::vector<int> axis_unknowns_;
  double reach_;
  SystemMatrix matrix_;
  Eigen::SimplicialLDLT<SystemMatrix, Eigen::Lower> solver_;
  std::vector<char> fixed_;
  Eigen::VectorXd residual_, change_, given_, along_load_;
  long factorisations_ = 0;
};

}  // namespace rebound::fem
