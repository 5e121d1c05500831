#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/implicit/point_law.hpp"
#include "fem/implicit/quadratic_motion.hpp"
#include "fem/implicit/system_matrix.hpp"

namespace rebound::fem {

/// Internal forces, consistent tangent and mass of a quadratic body.
/// Unknowns are (u_r, u_z) of node after node.
///
///   f = ∫ Bᵀ S dV,   K = ∂f/∂u = ∫ Bᵀ (∂S/∂E) B + S : ∂²E/∂u² dV,   B = ∂E/∂u
///
/// E and S are those of F̄ (QuadraticMotion), which is F unless the material would make the
/// cells lock in volume.
///
/// Limit:  f is the gradient of the energy, K the derivative of f
///         -> tests BodyForcesTest
class BodyForces {
 public:
  BodyForces(const QuadraticBody& body, const Material& material, ContactInertia inertia);

  int size() const { return 2 * body_.node_count(); }
  PointLaw& law() { return law_; }
  const PointLaw& law() const { return law_; }

  enum class Outcome { done, inverted };
  /// Internal force of every unknown at the end of the step.
  Outcome forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const;
  /// Also K + mass_weight · M.
  Outcome linearise(const Eigen::VectorXd& u, double mass_weight, Eigen::VectorXd& force,
                    SystemMatrix& matrix) const;
  /// The step is over: branches move to its end.
  void accept(const Eigen::VectorXd& u);

  /// What rounding leaves of the sum of forces on all nodes [N].
  double rounding() const;

  double stored_energy(const Eigen::VectorXd& u) const;

  /// What the branches have taken up to the last accepted instant [J], point by point.
  ///
  ///   taken   ∫ Σ Q:dE dV = ∫ Σ g W dV − ∫∫ Σ (D − Q):dE dV
  ///   held    see PointLaw::held_energy(); taken − held is dissipated
  ///
  /// The integral of D − Q by the trapezoidal rule: second order in the step at any relaxation
  /// time, for D − Q is smooth where Q is not.
  struct BranchEnergies {
    double taken = 0.0, held = 0.0;
  };
  BranchEnergies branch_energies(const Eigen::VectorXd& u) const;

  /// Calls use(F, S, stored energy per volume) at every point, cell after cell, as they
  /// are at the end of the step and before accept().
  template <class Use>
  void each_point(const Eigen::VectorXd& u, const Use& use) const {
    each(u, [&](const auto&, const auto&, const auto& f, const auto& c, std::size_t branch) {
      use(f, law_.stress(c, states_.data() + branch), law_.stored_energy(c));
    });
  }

  const SystemMatrix& mass() const { return mass_; }
  /// M applied to the unit axial velocity: what each node's u_z weighs in the mean.
  const Eigen::VectorXd& axial_mass() const { return axial_mass_; }

 private:
  /// Calls use(cell, point, F̄, C̄, its first branch) at every point; F̄ as QuadraticMotion has it.
  template <class Use>
  void each(const Eigen::VectorXd& u, const Use& use) const {
    std::size_t branch = 0;
    for (std::size_t k = 0; k < body_.cells.size(); ++k) {
      const QuadraticMotion motion = motion_of(k, u);
      for (int q = 0; q < quadratic_points; ++q) {
        use(body_.cells[k], body_.cells[k].points[q], motion.gradient(q),
            motion.right_cauchy_green(q), branch);
        branch += law_.branch_count();
      }
    }
  }
  QuadraticMotion motion_of(std::size_t cell, const Eigen::VectorXd& u) const;

  const QuadraticBody& body_;
  PointLaw law_;
  std::vector<DilatationProjection> projections_;  ///< by cell; empty: none needed
  std::vector<BranchState> states_;                ///< [cell][point][branch]
  std::vector<Symmetric<double>> last_strains_;  ///< C of the last accepted instant, [cell][point]
  double relaxed_work_ = 0.0;                    ///< ∫∫ Σ (D − Q):dE dV [J]
  SystemMatrix mass_;
  Eigen::VectorXd axial_mass_;
};

}  // namespace rebound::fem
