#pragma once

#include "lumped/problem/mechanisms.hpp"

/// One branch more beside the elastic force (quasi-linear viscoelasticity).
///
///   q̇ = s Ḟ_e − q/τ, carried as z:   q = s F_e − z,   ż = (s F_e − z)/τ
///
///   F_e   elastic force as it acts: after factors, set and hysteresis [N]
///   q     force of the branch, z the part of it that has relaxed     [N]
///   s     branch over long-term stiffness [-]     τ   relaxation time [s]
///
/// z needs no derivative of F_e and is smooth where F_e has corners.
/// Valid:   s ≥ 0, τ > 0.
/// Limit:   τ → ∞ is stiffness (1 + s) F_e, τ → 0 no branch
///          -> tests RelaxationTest.SlowBranchIsStiffness, FastBranchIsNothing.
/// Caution: the force falls to zero at x > 0: the ball leaves a dent that
///          recovers later. What is in a branch has no energy function; its
///          work is counted whole, held or dissipated.
/// Errors:  explicit steps run out for τ far below the contact time.
/// Source:  standard linear solid on a non-linear spring, e.g. Fung 1993.
namespace rebound {

inline double branch_force(const RelaxationBranch& branch, double elastic, double relaxed) {
  return branch.ratio * elastic - relaxed;
}

inline double relaxed_rate(const RelaxationBranch& branch, double elastic, double relaxed) {
  return branch_force(branch, elastic, relaxed) / branch.relaxation_time;
}

}  // namespace rebound
