#pragma once

#include <functional>
#include <vector>

#include "comparisons/discrepancy/trials/generator/impact_model.hpp"

namespace trials {

/// Branches whose sum follows a relaxation function between two times.
///
/// Ten relaxation times a constant ratio apart, from `from` to twice `to`; shares by non-negative
/// least squares at forty times.
std::vector<MaxwellBranch> branches_like(const std::function<double(double time)>& relaxation,
                                         double from, double to);

/// Σ share exp(−t/time).
double relaxation_of(const std::vector<MaxwellBranch>& branches, double time);

}  // namespace trials
