#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rebound::testing {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

enum class Privileges { keep, drop };

struct Invocation {
  std::vector<std::string> arguments;      ///< the program first
  std::filesystem::path folder;            ///< to run in
  std::vector<std::string> environment{};  ///< "NAME=value", beside the present one
  /// drop: as an unprivileged user, when the test runs as root. Paths must
  /// then be relative, since the way to the folder may be closed to it.
  Privileges privileges = Privileges::keep;
  long largest_file = 0;       ///< limit on the size of written files [bytes]; 0: none
  int interrupt_after_ms = 0;  ///< send SIGINT after this time; 0: never
};

/// Runs a program to its end and returns what it said.
Outcome run_program(const Invocation& run);

}  // namespace rebound::testing
