#pragma once

#include <vector>

#include "comparisons/report/figure.hpp"
#include "comparisons/report/table.hpp"
#include "comparisons/verification/verification_row.hpp"

namespace rebound {

/// What one part of the ladder brings: its rows, and pictures and tables that show them.
struct VerificationPart {
  VerificationTable rows;
  std::vector<report::Figure> figures{};
  std::vector<report::Table> tables{};
};

}  // namespace rebound
