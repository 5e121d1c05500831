#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fem/interface/material.hpp"
#include "fem/materials/kinematics.hpp"
#include "fem/materials/viscoelastic_constants.hpp"

namespace rebound::fem {

/// Branch stress Q and the stress D that drives it, at the last accepted instant [Pa].
struct BranchState {
  Symmetric<double> stress{};
  Symmetric<double> drive{};
};

/// Second Piola–Kirchhoff stress and its derivative, components rr, zz, tt, rz.
///
///   dS = tangent · (dE_rr, dE_zz, dE_tt, 2 dE_rz),   E = ½ (C − 1)
struct StressResponse {
  Eigen::Vector4d stress;
  Eigen::Matrix4d tangent;
};

/// The material at one integration point, with the tangent that belongs to the
/// update of its branches over one step.
///
///   S = c_d S_d + c_v S_v + Σ Qᵢ
///   Q(t+Δt) = a Q(t) + b [D(t+Δt) − D(t)],   D = g_d S_d + g_v S_v
///   a = exp(−Δt/τ),   b = (1 − a) τ/Δt
///
/// exact for a driving stress that is linear over the step. The derivatives
/// come from the stress itself by forward differentiation: no tangent is coded.
///
/// Limit:  tangent is the derivative of the stress, and symmetric
///         -> test PointLawTest
class PointLaw {
 public:
  explicit PointLaw(const Material& material);

  /// Length of the step to come [s]. Infinite: the fully relaxed state.
  void set_step(double step);

  /// Response at C = `right_cauchy_green`; `states` has one entry per branch.
  StressResponse respond(const Symmetric<double>& right_cauchy_green,
                         const BranchState* states) const;
  Symmetric<double> stress(const Symmetric<double>& right_cauchy_green,
                           const BranchState* states) const;

  /// Moves the branches to the end of the step.
  void accept(const Symmetric<double>& right_cauchy_green, BranchState* states) const;

  /// Hyperelastic energy of the long-term state per reference volume [J/m³].
  double stored_energy(const Symmetric<double>& right_cauchy_green) const;
  /// The same of the shares that drive branches: the work of all D.
  double driving_energy(const Symmetric<double>& right_cauchy_green) const;
  /// Σ (D − Q) of the last accepted instant [Pa].
  Symmetric<double> relaxed_stress(const BranchState* states) const;
  /// Σ g W |Q|²/|D|², |A|² = A:(g 𝕄)⁻¹:A with 𝕄 the moduli at rest: what the branches hold,
  /// exactly at small strain, and at any before and after relaxing [J/m³].
  double held_energy(const Symmetric<double>& right_cauchy_green, const BranchState* states) const;

  int branch_count() const { return static_cast<int>(constants_.branches.size()); }
  const ViscoelasticConstants& constants() const { return constants_; }

 private:
  struct Parts {
    Eigen::Vector4d deviatoric, volumetric;
  };
  Parts parts(const Symmetric<double>& right_cauchy_green) const;
  /// Hyperelastic energy per reference volume of these shares of the instantaneous law [J/m³].
  double energy_of(const Symmetric<double>& right_cauchy_green, double deviatoric_share,
                   double volumetric_share) const;
  /// Share of the instantaneous stress at the end of the step that the total has.
  struct StressWeights {
    double deviatoric = 0.0, volumetric = 0.0;
  };
  StressWeights weights() const;

  ViscoelasticConstants constants_;
  struct Update {
    double decay = 0.0, gain = 0.0;
  };
  std::vector<Update> updates_;
};

}  // namespace rebound::fem
