#pragma once

#include <string>
#include <vector>

#include "comparisons/app/session.hpp"

namespace rebound {

struct Command {
  std::string name;
  const char* summary;
  Declare declare;
};

/// All commands of commands.inc in the order --help lists them. A new command is one file
/// with a `declare_…` function and its line there.
const std::vector<Command>& commands();

}  // namespace rebound
