#pragma once

#include "comparisons/discrepancy/inspection/inspection.hpp"

/// What shots say of each other.
namespace rebound {

/// Mean and scatter of every number of shots within 2 % of one speed.
void add_repeats(Inspection& found);

/// Restitutions against the straight line between their neighbours in speed, added to the checks.
void add_restitution_checks(const Observations& seen, Inspection& found);

}  // namespace rebound
