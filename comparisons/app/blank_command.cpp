#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"

// To add a command: bash comparisons/setup/new command NAME
/// A command to copy. It compiles, and it is in no list.
namespace rebound {
namespace {

ExitCode run_blank(const Session& session, const std::string& word) {
  print_result(session, {{"schema", 1}, {"word", word}});
  return ExitCode::done;
}

}  // namespace

Action declare_blank(CLI::App& command) {
  const auto word = std::make_shared<std::string>();
  command.add_option("WORD", *word, "What is said back")->required();
  command.footer("Says a word back.\n\n" + exit_code_help());
  return [word](const Session& session) { return run_blank(session, *word); };
}

}  // namespace rebound
