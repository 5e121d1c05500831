#pragma once

#include <vector>

#include "comparisons/report/figure.hpp"
#include "comparisons/verification/verification_row.hpp"

namespace rebound {

/// What one part of the ladder brings: its rows, and pictures that show them.
struct VerificationPart {
  VerificationTable rows;
  std::vector<report::Figure> figures{};
};

}  // namespace rebound
