#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_score.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

/// What was hidden against what was said: colour is the share of a row, the number counts.
report::Matrix confusion_matrix(const ConfusionMatrix& confusion, const std::string& title,
                                const std::string& row_heading, const std::string& group);

/// Power over the size of the effect with its interval, one picture a question: bands would cover
/// each other. Bins without a trial have no point.
std::vector<report::Figure> power_figures(const RateTable& by_size);

}  // namespace rebound
