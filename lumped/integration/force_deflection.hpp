#pragma once

#include <span>
#include <vector>

#include "lumped/integration/direction.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

enum class Branch { loading, unloading };

/// Points of a force–deflection curve at which a force is wanted.
struct DeflectionPoints {
  std::vector<double> deflection;  ///< [m]
  std::vector<Branch> branch;
};

/// The deflections of a trace, loading up to the largest one.
DeflectionPoints deflection_points(const Trace& trace);

/// The law's own force at given deflections, in newtons, from the fast
/// integrator's steps: v where u(τ) = √x on the branch, then F(x, v).
///
/// Beyond the law's largest deflection the force at its turning point is
/// returned, before a branch's open end the force there: continuous whatever
/// is asked, so that a fit can walk through it.
///
/// With mechanisms beside the law it is what the instrument reads, over the
/// deflection of the centre of mass.
///
/// Valid:   every law and mechanism, both separation rules.
/// Limit:   the implicit v–x relation of Hunt–Crossley
///          -> test ForceDeflectionTest.FollowsTheImplicitRelation.
/// Caution: dF/dx is infinite at the turning point of a damped law.
/// Errors:  as simulate_fast().
std::vector<double> forces_at(const LumpedProblem& problem, const DeflectionPoints& points);

/// Forces with their derivatives by a few parameters.
struct ForcesWithSensitivities {
  std::vector<double> force;   ///< [N]
  std::vector<double> slopes;  ///< one row a point, one column a direction
};

/// The same for a law alone, with the slopes of the force at fixed deflection,
///
///   dF/dp = F_p + F_v (δv − v̇/ẋ δx),
///
/// by the variational equations of FastIntegrator.
///
/// Limit:   central differences of forces_at()
///          -> test ForceDeflectionTest.SlopesAreThoseOfTheForces.
/// Caution: infinite at the turning point of a damped law.
/// Errors:  as simulate_fast(); Error(bad_input) for mechanisms beside the law.
ForcesWithSensitivities forces_with_sensitivities_at(const LumpedProblem& problem,
                                                     const DeflectionPoints& points,
                                                     std::span<const Direction> by);

}  // namespace rebound
