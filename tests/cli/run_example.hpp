#pragma once

#include <string>

#include "tests/cli/program.hpp"

namespace rebound::testing {

/// Writes an example into a folder whose name a shell would take apart, and runs what it proposes.
inline void run_example(const TemporaryFolder& folder, const std::string& name) {
  const std::string where = "a folder of " + name;
  const Outcome init =
      run_program({.arguments = {REBOUND_PROGRAM, "init", name, "--out", where, "--json"},
                   .folder = folder.path()});
  ASSERT_EQ(init.exit_code, 0) << init.errors;
  const auto next = nlohmann::json::parse(init.output)["next"];
  ASSERT_FALSE(next.empty());
  for (const std::string command : next) {
    const std::string program = replaced(command, "rebound ", std::string(REBOUND_PROGRAM) + " ");
    const Outcome outcome =
        run_program({.arguments = {"/bin/sh", "-c", program}, .folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.errors;
  }
}

}  // namespace rebound::testing
