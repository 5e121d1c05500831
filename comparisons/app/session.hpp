#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/io/results/provenance.hpp"
#include "lumped/problem/error.hpp"

namespace CLI {
class App;
}

namespace rebound {

enum class OutputFormat { text, json };

/// What every command is told: the common options and how it was called.
struct Session {
  OutputFormat format = OutputFormat::text;
  std::filesystem::path out;  ///< of --out; empty when not given
  int threads = 0;            ///< of --threads; all processors where not given
  std::vector<std::string> command_line;

  bool json() const { return format == OutputFormat::json; }
};

/// Runs a command whose options were parsed. Errors are thrown as Error.
using Action = std::function<ExitCode(const Session&)>;

/// Adds a command's own options and gives back what to run.
using Declare = Action (*)(CLI::App&);

/// Provenance of a run on `input_file`, whose text is `input`.
Provenance provenance_of(const Session& session, const std::string& input_file,
                         std::string_view input);

/// The same of a run that took the FE tier.
Provenance provenance_with_fem(const Session& session, const std::string& input_file,
                               std::string_view input);

/// The exit codes, as printed by every --help.
std::string exit_code_help();

}  // namespace rebound
