#pragma once

#include "comparisons/inference/references/law_score.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// A key for each error, null where the reference has no such value.
Json to_json(const ScalarErrors& errors);

}  // namespace rebound
