#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "comparisons/accuracy/verification/verification_part.hpp"

namespace rebound::test {

/// Every row passes, and there are at least `least` of them, all named and sourced.
inline void expect_rows(const VerificationTable& rows, std::size_t least) {
  EXPECT_GE(rows.size(), least);
  std::set<std::string> names;
  for (const VerificationRow& row : rows) {
    EXPECT_TRUE(row.passes()) << row.quantity << ": " << row.result << " for " << row.target;
    EXPECT_FALSE(row.source.empty()) << row.quantity;
    EXPECT_TRUE(names.insert(row.case_id + row.quantity).second) << "twice: " << row.quantity;
  }
}

}  // namespace rebound::test
