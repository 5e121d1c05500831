#pragma once

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"

namespace rebound {

/// Fits a believed model wherever its numbers start.
///
/// Every unknown number of the law is tried over a grid of factors, 1/16 to 16; the joint fit is
/// started from the believed numbers and from the best points of the grid, and the best search
/// is kept. `hypothesis.believed` of what comes back holds the numbers it was started from.
///
/// Limit: stiffness an eighth or eight times the truth gives the same fit
///        -> test NotFooledTest.TheStartDoesNotDecide.
/// Errors: as fit_hypothesis().
HypothesisFit fit_believed(const Observations& seen, const Hypothesis& hypothesis,
                           const RunControl& control = {},
                           SearchEffort effort = SearchEffort::whole);

/// The believed model fitted, and looked at closely: beside it stand all effects that it lacks.
/// Errors: as above.
AssessedFit assess_believed(const Observations& seen, const Hypothesis& believed,
                            const SelectionRules& rules, std::uint64_t seed,
                            const RunControl& control = {});

}  // namespace rebound
