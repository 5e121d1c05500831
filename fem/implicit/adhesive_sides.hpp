#pragma once

#include <Eigen/Core>

#include "fem/implicit/system_matrix.hpp"
#include "fem/interface/adhesive_traction.hpp"

namespace rebound::fem {

/// Adhesive traction (AdhesiveTraction) between the plate z = 0 and the quadratic
/// sides of the contact group, by three Gauss points a side.
///
///   f_i = Σ_q N_i T(g_q) A_q,   ∂f_i/∂z_j = Σ_q N_i N_j T′(g_q) A_q,   A = 2π R ds at rest
///
/// counted as internal forces are: what the body needs to be held against it.
/// Limit: f is the gradient of the potential -> test AdhesiveSidesTest
class AdhesiveSides {
 public:
  AdhesiveSides(const QuadraticBody& body, const AdhesiveTraction& traction);

  void add_forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const;
  void add_derivative(const Eigen::VectorXd& u, SystemMatrix& matrix) const;
  double pull(const Eigen::VectorXd& u) const;       ///< on the whole body, towards the plate [N]
  double potential(const Eigen::VectorXd& u) const;  ///< −Σ A_q w (1 − g_q/r)², ≤ 0 [J]
  double energy(const Eigen::VectorXd& u) const {    ///< potential against that at first touch [J]
    return potential(u) - potential_at_rest_;
  }

 private:
  /// Calls use(side, point, g/r) at every point.
  template <class Use>
  void each_point(const Eigen::VectorXd& u, const Use& use) const;

  const QuadraticBody& body_;
  AdhesiveTraction traction_;
  double potential_at_rest_ = 0.0;
};

}  // namespace rebound::fem
