#pragma once

#include <string>
#include <vector>

#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// Parameters of the law in the order of its card, then "mass" and "speed".
std::vector<std::string> names_of_directions(const std::string& law);

/// Errors: Error(bad_input) for mechanisms beside the law, or a law with a state of its own.
void require_bare(const LumpedProblem& problem);

}  // namespace rebound
