#pragma once

#include <cmath>

#include "lumped/problem/mechanisms.hpp"

/// One branch more beside the elastic force (quasi-linear viscoelasticity).
///
///   q̇ = s Ġ − q/τ, carried as z:   q = s G − z,   ż = (s G − z)/τ,   G = F_e (x/x_r)^p
///
///   F_e   elastic force as it acts: after factors, set and hysteresis [N]
///   G     what drives the branch: F_e itself for p = 0 [N]   x_r   R/10 [m]
///   q     force of the branch, z the part of it that has relaxed     [N]
///   s     branch over long-term stiffness [-]     τ   relaxation time [s]
///   p     power by which the spring of the branch differs from that of the law [-]
///
/// z needs no derivative of F_e and is smooth where F_e has corners.
/// Valid:   s ≥ 0, τ > 0; −p less than the exponent of F_e, so that a branch begins at no force.
/// Limit:   τ → ∞ is stiffness (1 + s) F_e, τ → 0 no branch
///          -> tests RelaxationTest.SlowBranchIsStiffness, FastBranchIsNothing;
///          on Hertz p = −1/2 is a linear spring
///          -> test RelaxationTest.AnExponentMakesTheSpringOfABranchLinear.
/// Caution: the force falls to zero at x > 0: the ball leaves a dent that
///          recovers later. What is in a branch has no energy function; its
///          work is counted whole, held or dissipated.
/// Errors:  explicit steps run out for τ far below the contact time.
/// Source:  standard linear solid on a non-linear spring, e.g. Fung 1993.
namespace rebound {

/// G at a deflection over x_r.
inline double branch_drive(const RelaxationBranch& branch, double elastic, double share) {
  if (branch.exponent == 0.0 || !(share > 0.0)) return elastic;
  return elastic * std::pow(share, branch.exponent);
}

inline double branch_force(const RelaxationBranch& branch, double drive, double relaxed) {
  return branch.ratio * drive - relaxed;
}

inline double relaxed_rate(const RelaxationBranch& branch, double drive, double relaxed) {
  return branch_force(branch, drive, relaxed) / branch.relaxation_time;
}

}  // namespace rebound
