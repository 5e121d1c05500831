#pragma once

#include <string>

#include "comparisons/discrepancy/trials/trial_score.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

Json to_json(const TrialScores& scores);
std::string to_text(const TrialScores& scores);
report::Report trial_report(const TrialScores& scores);

}  // namespace rebound
