#pragma once

#include <vector>

#include "comparisons/accuracy/tier_comparison/compare_file.hpp"

namespace rebound::testing {

/// The lumped tier of the study's twelve cases.
inline std::vector<CompareCase> lumped_cases() {
  std::vector<CompareCase> cases;
  for (const char* core : {"core-a", "core-b", "core-c", "core-d"}) {
    CompareCase& one = cases.emplace_back();
    one.name = core;
    one.lumped = one.name + "-lumped.toml";
    one.speeds = {"5 m/s", "15 m/s", "25 m/s"};
  }
  return cases;
}

}  // namespace rebound::testing
