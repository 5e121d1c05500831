#pragma once

#include "comparisons/discrepancy/trials/trial_score.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

/// Gates, power, confusion and controls of blind trials as a page.
report::Report trial_report(const TrialScores& scores);

}  // namespace rebound
