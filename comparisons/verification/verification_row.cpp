#include "comparisons/verification/verification_row.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace rebound
