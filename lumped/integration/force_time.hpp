#pragma once

#include <span>
#include <vector>

#include "lumped/integration/direction.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// The force of one impact at instants of its own clock, zero outside the contact.
struct TimedForces {
  std::vector<double> force;   ///< [N]
  std::vector<double> rate;    ///< dF/dt [N/s]
  std::vector<double> slopes;  ///< dF/dp at fixed time: one row an instant, one column a direction
};

/// Forces of a law alone at any instants, from the fast integrator's steps.
///
/// Limit:  the samples of simulate_fast()
///         -> test ForceTimeTest.GivesBackTheTrace; slopes and rate against central
///         differences -> test ForceTimeTest.SlopesAreThoseOfTheForces.
/// Errors: as simulate_fast(); Error(bad_input) for mechanisms beside the law.
TimedForces forces_at_instants(const LumpedProblem& problem, std::span<const double> instants,
                               std::span<const Direction> by = {});

}  // namespace rebound
