#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// A diagnosis under the key names that scripts rely on; numbers in SI.
/// "extended_model" and "report" are left null: whoever writes them fills them in.
Json to_json(const Diagnosis& diagnosis);

}  // namespace rebound
