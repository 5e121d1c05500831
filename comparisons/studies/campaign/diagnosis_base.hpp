#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// A diagnosis as a campaign repeats it: a believed model against data that stand in folders, or
/// against an experiment that is made anew for every member.
struct DiagnosisFile {
  std::string believed;           ///< impact file, relative to this file
  std::vector<std::string> data;  ///< data-set folders, diagnosed together
  std::string experiment;         ///< in their place: a synthesis file
  std::int64_t seed = 1;
  std::optional<double> held_out_speed;  ///< [m/s]
  bool hold_out = true;
  bool bootstrap = true;
  bool ask_fem = true;
};

void describe(Visitor& visit, DiagnosisFile& file);

}  // namespace rebound
