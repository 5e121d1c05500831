#pragma once

#include "lumped/problem/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// The seed paper's core A at 15 m/s with the Hunt–Crossley numbers of its
/// Table 3. Source: Hanley et al., sliotar core impact, Tables 1 and 3.
LumpedProblem example_lumped_problem();

/// A ball of core A's mass and size with round material numbers: something to
/// start from, not a calibrated core.
FemProblem example_fem_problem();

}  // namespace rebound
