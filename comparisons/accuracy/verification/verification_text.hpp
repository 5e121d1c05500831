#pragma once

#include <string>

#include "comparisons/accuracy/verification/verification_row.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// {"schema": 1, "passed", "rows": [{case, quantity, unit, target, result,
/// deviation, tolerance, tolerance_scale, order, passed, source}]}; tolerance_scale
/// "relative", "absolute" or "upper_bound" (the target is the largest value), order null
/// where no family was run, a result that is no number null.
Json to_json(const VerificationTable& table);

/// The same as a table with a head line; texts in quotes.
std::string to_csv(const VerificationTable& table);

/// The same as aligned columns, failures marked, with a last line of counts.
std::string to_text(const VerificationTable& table);

}  // namespace rebound
