#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
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
  /// Of a plate that moves: stiffness · y + load = Σ λ, y its displacement.
  struct PlateBalance {
    double stiffness = 0.0;  ///< [N/m]
    double load = 0.0;       ///< [N]
  };
  std::optional<PlateBalance> plate{};
  /// Without inertia and without a plate that holds it, a body is nowhere.
  bool needs_contact = false;
};

/// Newton's method with a sparse direct solve, on a system whose contact nodes
/// are held or free. A plate that moves is one unknown more: how the body answers to its motion,
/// w with −1 at every held node, is found with the same factors,
///
///   P (y + δ) + q = Σ_held (r + K (Δu + δ w))
///
///   r residual, Δu the change while the plate rests, P and q of EquilibriumTask::plate
///
/// Ends when the residual of the free unknowns is below 1e-9
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
  bool solve_change(const EquilibriumTask& task, const Eigen::VectorXd& u, ActiveSet& held,
                    Result& result);
  void move_plate(const EquilibriumTask::PlateBalance& plate, ActiveSet& held,
                  const Eigen::VectorXd& u);
  double plate_miss(const EquilibriumTask& task, const ActiveSet& held) const;

  std::vector<int> axis_nodes_;
  double reach_;
  SystemMatrix matrix_;
  std::optional<SystemMatrix> whole_;  ///< before it was condensed; where the plate moves
  ConstrainedSolver solver_;
  ConstrainedSolver::Given fixed_;  ///< changes that are known
  Eigen::VectorXd residual_, change_;
  double plate_change_ = 0.0;
};

}  // namespace rebound::fem
