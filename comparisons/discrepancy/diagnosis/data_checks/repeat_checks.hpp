#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/data_checks/checked_shots.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"

namespace rebound {

/// Shots of one ball at one speed against each other, and over the order in which they were made.
///
///   impulse ~ v,   peak ~ v^(6/5),   width ~ v^(−1/5)
///
/// bring the shots of a group to one speed; what their exponents may be off by, 0.15 at most for a
/// power law between 1 and 2, counts as an error. Speeds within 2 % are one.
/// Order: one slope in all groups together, where there are six repeats or more. One odd shot at an
/// end makes a slope, too: the check that is further out says which it is. Shots at
/// different speeds say nothing of order, for what follows the speed would follow it, too.
std::vector<DataCheck> repeat_checks(const std::vector<CheckedShot>& shots);

}  // namespace rebound
