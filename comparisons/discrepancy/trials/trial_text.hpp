#pragma once

#include <string>

#include "comparisons/discrepancy/trials/trial_score.hpp"

namespace rebound {

Json to_json(const TrialScores& scores);
std::string to_text(const TrialScores& scores);

/// "27 of 60 = 45.0 % [33.1, 57.5]", or "none" of none.
std::string share_text(const Share& share);

/// Count, of how many, the share (null of none) and its interval.
Json share_json(const Share& share);
/// What is asked of a share, e.g. "at most 5 %, upper bound 7.5 %"; "-" where nothing is.
std::string asked_text(const TrialGate& gate);
/// All names of the columns of a confusion matrix.
std::vector<std::string> columns_of(const ConfusionMatrix& confusion);

}  // namespace rebound
