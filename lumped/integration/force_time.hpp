#pragma once

#include <span>
#include <vector>

#include "lumped/integration/direction.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// The force of one impact at instants of its own clock, zero outside the contact.
struct TimedForces {
  std::vector<double> force;   ///< [N]
  std::vector<double> rate;    ///< dF/dt; empty for a composed contact [N/s]
  std::vector<double> slopes;  ///< dF/dp at fixed time: one row an instant, one column a direction
};

/// Forces at any instants, from the fast integrators' steps; slopes of a law alone.
///
/// Limit:  the samples of simulate_fast()
///         -> test ForceTimeTest.GivesBackTheTrace; slopes and rate against central
///         differences -> test ForceTimeTest.SlopesAreThoseOfTheForces.
/// Errors: as simulate_fast(); Error(bad_input) for slopes of a composed contact.
TimedForces forces_at_instants(const LumpedProblem& problem, std::span<const double> instants,
                               std::span<const Direction> by = {});

}  // namespace rebound
