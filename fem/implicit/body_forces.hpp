#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "fem/implicit/point_law.hpp"
#include "fem/implicit/quadratic_body.hpp"

namespace rebound::fem {

using SystemMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;  ///< lower triangle

/// Inertia of the nodes next to the plate.
enum class ContactInertia {
  kept,
  removed  ///< contact nodes move in z without mass of their own; see BodyForces
};

/// Internal forces, consistent tangent and mass of a quadratic body.
/// Unknowns are (u_r, u_z) of node after node.
///
///   f = ∫ Bᵀ S dV,   K = ∂f/∂u = ∫ Bᵀ (∂S/∂E) B + ∇N · S ∇N dV
///   kinetic energy ½ vᵀ M v,   M_ij = ∫ ρ N_i N_j dV
///
/// With ContactInertia::removed the axial velocity of a contact node that M
/// sees is the linear extension of the two nodes behind it, v = 2 v₁ − v₂. The
/// mass stays what it is, to the last digit, and every linear velocity field
/// keeps its kinetic energy; but a contact node has no inertia of its own, so
/// that it meets and leaves the plate without a blow.
///
/// Limit:  f is the gradient of the energy, K the derivative of f
///         -> tests BodyForcesTest
/// Source: mass at the contact removed: Khenous, Laborde & Renard 2008.
class BodyForces {
 public:
  BodyForces(const QuadraticBody& body, const Material& material, ContactInertia inertia);

  int size() const { return 2 * body_.node_count(); }
  PointLaw& law() { return law_; }
  const PointLaw& law() const { return law_; }

  enum class Outcome { done, inverted };
  /// Internal force of every unknown at the end of the step.
  Outcome forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const;
  struct Weights {
    double stiffness = 1.0, mass = 0.0;
  };
  /// Also weights.stiffness · K + weights.mass · M.
  Outcome linearise(const Eigen::VectorXd& u, const Weights& weights, Eigen::VectorXd& force,
                    SystemMatrix& matrix) const;
  /// The step is over: branches move to its end.
  void accept(const Eigen::VectorXd& u);

  /// What rounding leaves of the sum of forces on all nodes [N].
  double rounding() const;

  double stored_energy(const Eigen::VectorXd& u) const;

  /// Calls use(F, S, stored energy per volume) at every point, cell after cell, as they
  /// are at the end of the step and before accept().
  template <class Use>
  void each_point(const Eigen::VectorXd& u, const Use& use) const {
    const BranchState* states = states_.data();
    for (const auto& cell : body_.cells)
      for (const auto& point : cell.points) {
        Gradient<double> f;
        const Symmetric<double> c = right_cauchy_green(cell, point, u, f);
        use(f, law_.stress(c, states), law_.stored_energy(c));
        states += law_.branch_count();
      }
  }

  const SystemMatrix& mass() const { return mass_; }  ///< lower triangle
  Eigen::VectorXd times_mass(const Eigen::VectorXd& v) const;
  /// M applied to the unit axial velocity: what each node's u_z weighs in the mean.
  const Eigen::VectorXd& axial_mass() const { return axial_mass_; }
  SystemMatrix empty_matrix() const { return pattern_; }

 private:
  Symmetric<double> right_cauchy_green(const QuadraticCell& cell, const QuadraticCell::Point& point,
                                       const Eigen::VectorXd& u, Gradient<double>& f) const;
  void make_pattern(ContactInertia inertia);

  const QuadraticBody& body_;
  PointLaw law_;
  std::vector<BranchState> states_;  ///< [cell][point][branch]
  SystemMatrix pattern_, mass_;
  std::vector<int> places_;          ///< [cell][171] where an entry of the lower triangle is
  std::vector<double> mass_values_;  ///< in the order of the pattern
  Eigen::VectorXd axial_mass_;
};

}  // namespace rebound::fem
