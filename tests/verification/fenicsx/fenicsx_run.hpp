#pragma once

#include <string>

#include "fem/interface/fem_problem.hpp"

namespace rebound::test {

/// What the script prints.
struct FenicsxResult {
  double restitution = 0.0;
  double peak_deflection = 0.0;  ///< [m]
  double peak_force = 0.0;       ///< largest mean over the FE tier's window [N]
};

/// Writes the deck of the problem, runs it, reads what it prints.
/// Errors: std::runtime_error where it does not complete.
FenicsxResult run_fenicsx(const FemProblem& problem);

/// The ball of the tests: 89.6 g, 66.2 mm, 10 MPa, Poisson ratio 0.4, 15 m/s.
FemProblem ball_at_15();

}  // namespace rebound::test
