#include "comparisons/accuracy/verification/expected_rows.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rebound {

const std::vector<ExpectedRow>& expected_rows() {
#define REBOUND_ROW(tier, case_id, quantity) {ExpectedRow::Tier::tier, case_id, quantity},
  static const std::vector<ExpectedRow> rows = {
#include "comparisons/accuracy/verification/expected_rows.inc"
  };
#undef REBOUND_ROW
  return rows;
}

std::vector<std::string> missing_rows(const VerificationTable& table,
                                      const std::vector<ExpectedRow::Tier>& tiers) {
  std::multiset<std::pair<std::string, std::string>> there;
  for (const VerificationRow& row : table) there.emplace(row.case_id, row.quantity);
  std::vector<std::string> missing;
  for (const ExpectedRow& row : expected_rows()) {
    if (std::find(tiers.begin(), tiers.end(), row.tier) == tiers.end()) continue;
    const auto found = there.find({row.case_id, row.quantity});
    if (found == there.end())
      missing.push_back(row.case_id + ": " + row.quantity);
    else
      there.erase(found);
  }
  return missing;
}

VerificationRow row_of_missing(const std::vector<std::string>& missing) {
  return {.case_id = "suite",
          .quantity = "expected rows that are missing",
          .unit = "",
          .target = 0.0,
          .result = static_cast<double>(missing.size()),
          .tolerance = 0.0,
          .scale = ToleranceScale::upper_bound,
          .source = "expected_rows.inc"};
}

}  // namespace rebound
