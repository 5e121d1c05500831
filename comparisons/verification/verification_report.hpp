#pragma once

#include "comparisons/report/report.hpp"
#include "comparisons/verification/ladder.hpp"

namespace rebound {

/// The ladder as a page: the pictures of its parts, every row with its verdict,
/// and what an interruption left out.
report::Report verification_report(const LadderOutcome& ladder);

}  // namespace rebound
