#pragma once

#include <functional>
#include <string>

#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What a process of its own may do.
struct Isolation {
  enum class Files { none, writes };
  Files files = Files::none;     ///< may it write files at all?
  double memory = 1e9;           ///< beyond what this process has mapped [B]
  double seconds = 600.0;        ///< of processor time
  const char* program = "Gmsh";  ///< who is at work, in messages
};

/// Runs `work` in a process of its own and returns what it returned.
///
/// The process has nothing on standard input, output and error, leaves no core file, and is ended
/// when this one ends or is interrupted. An Error that `work` throws is thrown here. Errors:
/// Error(bad_input) where the process ended otherwise; Error(interrupted);
///         Error(input_output_failed) where it cannot be started.
std::string isolated(const std::function<std::string()>& work, const Isolation& limits,
                     const RunControl& control);

}  // namespace rebound
