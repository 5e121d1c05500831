#pragma once

#include "fem/materials/moduli.hpp"
#include "lumped/problem/fem_problem.hpp"

namespace rebound::fem {

/// Contact time of the Hertz impact with the instantaneous modulus [s]: only
/// the yardstick of default output interval and end time.
double expected_contact_time(const FemProblem& problem, const Moduli& moduli);

/// Refuses a problem outside the tier's range.
/// Errors: Error(bad_input) for numbers that are not finite or out of range,
///         an output interval that would exhaust memory, and zero-deflection
///         separation. The material is checked by viscoelastic_constants().
void check_problem(const FemProblem& problem);

}  // namespace rebound::fem
