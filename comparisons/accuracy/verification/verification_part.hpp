#pragma once

#include <vector>

#include "comparisons/accuracy/verification/verification_row.hpp"
#include "comparisons/io/report/figure.hpp"
#include "comparisons/io/report/table.hpp"

namespace rebound {

/// What one part of the verification suite brings: its rows, and pictures and tables that show
/// them.
struct VerificationPart {
  VerificationTable rows;
  std::vector<report::Figure> figures{};
  std::vector<report::Table> tables{};
};

}  // namespace rebound
