#pragma once

#include "comparisons/config/visitor.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

void describe(Visitor& visit, LumpedControls& controls);

/// The members of `[model]` of a lumped impact file. Which they are, and in
/// which units, the card of the chosen law says.
void describe_lumped_model(Visitor& visit, LumpedModel& model);

/// A whole lumped impact file.
void describe(Visitor& visit, LumpedProblem& problem);

}  // namespace rebound
