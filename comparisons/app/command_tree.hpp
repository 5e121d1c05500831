#pragma once

#include "comparisons/app/commands.hpp"

namespace rebound {

/// One CLI11 sub-command per line of commands.inc, with the options that all share. Parsing
/// fills `session` and sets `chosen`; both must outlive `app`.
void declare_commands(CLI::App& app, Session& session, Action& chosen);

/// Of a command line that was refused: what the misspelt command or option probably was, as a
/// sentence that ends a message; empty where nothing is near.
std::string nearest_usage(const CLI::App& app, const std::vector<std::string>& command_line);

/// What somebody who typed the program's name alone may want to do next.
std::string next_steps();

}  // namespace rebound
