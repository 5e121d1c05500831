#include "comparisons/accuracy/verification/verification_row.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rebound {

double VerificationRow::deviation() const {
  if (scale == ToleranceScale::upper_bound && result <= target) return 0.0;
  const double off = std::abs(result - target);
  return scale == ToleranceScale::relative ? off / std::abs(target) : off;
}

bool all_pass(const VerificationTable& table) {
  return !table.empty() &&
         std::all_of(table.begin(), table.end(), [](const auto& row) { return row.passes(); });
}

void append(VerificationTable& table, VerificationTable rows) {
  for (VerificationRow& row : rows) table.push_back(std::move(row));
}

}  // namespace rebound
