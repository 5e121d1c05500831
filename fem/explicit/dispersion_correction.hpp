#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/explicit/node_laplacian.hpp"

namespace rebound::fem {

/// Takes out most of what a lumped mass slows short waves by.
///
///   a = y + M⁻¹ L y,   y = M⁻¹ f,   L = Σ_cells α_c (M − M_c),   α_c = (1 − q ω_c²/ω²)/2
///
///   M    lumped mass [kg];  M_c consistent mass, of the same row sums [kg]
///   f    internal forces [N];  y  their accelerations with the lumped mass
///   ω_c  frequency of cell c alone, ω the largest of all [1/s]
///   q    (ω Δt/2)², Δt the step: q = 3/2 − √(9/4 − 2 s²), s the step safety
///
/// M⁻¹ + M⁻¹ L M⁻¹ is to first order the inverse of M − L: a mass between lumped
/// and consistent, without a solve. A wave of wave number k on cells h that are
/// stepped at r of their own limit runs slow by (1 − r² − 2 α)(k h)²/24 of its
/// speed: central differences make up r² of it, α the rest.
///
/// Nodes that may touch the plate take no part: what they are pushed with is
/// not known before the plate has answered. The correction is a sum over pairs
/// of nodes, of equal and opposite momentum.
///
/// Valid:   with a step shorter by step_factor(), √(q)/s: M − M_c < M lets the frequency
///          of a cell grow by no more than √(1 + α_c), most for the stiffest
///          -> test DispersionCorrectionTest.LeavesTheStepSafe.
/// Limit:   s = 1 leaves a uniform mesh lumped; a rigid motion is left as it is
///          -> tests DispersionCorrectionTest.
/// Source:  Krenk, Comput. Methods Appl. Mech. Eng. 191 (2001) 975; Marfurt,
///          Geophysics 49 (1984) 533.
class DispersionCorrection {
 public:
  /// Stable step with the correction over that without; `step_safety` s in (0, 1].
  static double step_factor(double step_safety);

  /// `frequency_squared`: ω_c² per cell of the body [1/s²].
  DispersionCorrection(const Discretisation& body, const std::vector<double>& frequency_squared,
                       double step_safety);

  /// f + L y: the force whose accelerations with the lumped mass are a.
  /// [node][2] (r, z); `inverse_mass` is zero where a node is held.
  std::vector<double> corrected(const std::vector<double>& inverse_mass,
                                const std::vector<double>& force) const {
    return laplacian_.added_to(force, inverse_mass);
  }

  /// v − a `span`, in one pass over the nodes.
  void kick(double span, const std::vector<double>& inverse_mass, const std::vector<double>& force,
            std::vector<double>& velocity) {
    laplacian_.kick(span, inverse_mass, force, velocity);
  }

  /// ½ vᵀ L v, the mean of two velocities: what the kinetic energy is less than that of the lumped
  /// mass [J].
  double mean_kinetic(const std::vector<double>& before, const std::vector<double>& after) const {
    return 0.5 * laplacian_.half_squares(before, after);
  }

 private:
  NodeLaplacian laplacian_;  ///< L: of weights m_ij = Σ_c α_c ∫ ρ N_i N_j dV
};

}  // namespace rebound::fem
