#include "comparisons/app/commands.hpp"

#include <algorithm>

namespace rebound {

#define REBOUND_COMMAND(name, summary) Action declare_##name(CLI::App& command);
#include "comparisons/app/commands.inc"
#undef REBOUND_COMMAND

static std::string as_typed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

const std::vector<Command>& commands() {
#define REBOUND_COMMAND(name, summary) {as_typed(#name), summary, declare_##name},
  static const std::vector<Command> table{
#include "comparisons/app/commands.inc"
  };
#undef REBOUND_COMMAND
  return table;
}

}  // namespace rebound
