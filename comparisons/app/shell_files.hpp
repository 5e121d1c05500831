#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What shells and `man` read, written from the same tables as --help.
namespace rebound {

/// The shells that have completions.
const std::vector<std::string>& shells();

/// Completion of commands, options, their choices and file names for one of shells().
/// Caution: `app` has its commands declared (declare_commands).
std::string completion_script(const CLI::App& app, const std::string& shell);

/// The manual page of one command, or of the program where `command` is empty, as roff.
std::string manual_page(const CLI::App& app, const std::string& command);

}  // namespace rebound
