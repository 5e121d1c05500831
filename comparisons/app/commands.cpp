#include "comparisons/app/commands.hpp"

namespace rebound {

const std::vector<Command>& commands() {
  static const std::vector<Command> table{
      {"lumped", "one trace of a lumped contact law", declare_lumped},
      {"schema", "JSON schema of a file format", declare_schema},
  };
  return table;
}

}  // namespace rebound
