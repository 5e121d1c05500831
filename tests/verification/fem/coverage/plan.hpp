#pragma once

#include <vector>

#include "comparisons/accuracy/numerical_error/coverage.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// A family of runs that the campaign is made of.
struct PlannedFamily {
  CoverageRow row;  ///< without a quantity and values
  FemProblem problem;
};

/// Thirty points over speed, Poisson ratio and branch, by a Halton sequence, six more of nearly
/// incompressible balls, and their families.
std::vector<PlannedFamily> planned_families();

/// What a family takes, in no unit. Points are run one by one, the cheapest first: without its
/// truth no bar of a point is judged.
double relative_cost(const PlannedFamily& family);

/// Three families of few cells of one ball: seconds, to see the campaign at work.
std::vector<PlannedFamily> families_to_try();

}  // namespace rebound
