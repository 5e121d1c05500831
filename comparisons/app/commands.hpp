#pragma once

#include <vector>

#include "comparisons/app/session.hpp"

namespace rebound {

struct Command {
  const char* name;
  const char* summary;
  Declare declare;
};

/// All commands in the order --help lists them. A new command is one file
/// with a `declare_…` function, its declaration below, and its line in
/// commands.cpp.
const std::vector<Command>& commands();

Action declare_study(CLI::App& command);
Action declare_reproduce(CLI::App& command);
Action declare_lumped(CLI::App& command);
Action declare_fem(CLI::App& command);
Action declare_compress(CLI::App& command);
Action declare_mesh(CLI::App& command);
Action declare_calibrate(CLI::App& command);
Action declare_benchmark(CLI::App& command);
Action declare_atlas(CLI::App& command);
Action declare_select(CLI::App& command);
Action declare_convert(CLI::App& command);
Action declare_drop(CLI::App& command);
Action declare_verify(CLI::App& command);
Action declare_synthesize(CLI::App& command);
Action declare_diagnose(CLI::App& command);
Action declare_init(CLI::App& command);
Action declare_schema(CLI::App& command);
Action declare_doctor(CLI::App& command);

}  // namespace rebound
