#pragma once

#include "lumped/integration/contact_end.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// What the integrators need of a problem.
/// Errors: Error(bad_input) for controls outside their limits; mass and speed are checked with
/// the law.
ContactSetup checked_setup(const LumpedProblem& problem);

}  // namespace rebound
