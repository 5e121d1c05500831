#pragma once

#include <string>
#include <vector>

#include "comparisons/accuracy/verification/verification_row.hpp"

namespace rebound {

/// A row by what it is of, and which cases bring it.
struct ExpectedRow {
  enum class Tier { lumped, fem, faults };
  Tier tier;
  std::string case_id;
  std::string quantity;
};

/// The list of expected_rows.inc.
const std::vector<ExpectedRow>& expected_rows();

/// Those of `tiers` that `table` does not hold, as "case: quantity". A row that is there twice
/// has to be listed twice.
std::vector<std::string> missing_rows(const VerificationTable& table,
                                      const std::vector<ExpectedRow::Tier>& tiers);

/// How many are missing, as a row that fails above none: a case that returns nothing must not
/// pass for want of a row to judge.
VerificationRow row_of_missing(const std::vector<std::string>& missing);

}  // namespace rebound
