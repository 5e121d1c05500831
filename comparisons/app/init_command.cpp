#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/examples.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/config/describe_fem.hpp"
#include "comparisons/config/describe_lumped.hpp"
#include "comparisons/config/toml_writer.hpp"
#include "comparisons/results/atomic_file.hpp"

namespace rebound {
namespace {

/// A file to start from: its name, what to do with it, its text. Other rooms
/// add theirs here.
struct Starter {
  const char* file;
  const char* use;
  std::string (*text)();
};

const std::vector<Starter>& starters() {
  static const std::vector<Starter> list{
      {"lumped.toml", "rebound lumped",
       [] { return write_toml(example_lumped_problem(), Comments::sentences); }},
      {"fem.toml", "rebound fem",
       [] { return write_toml(example_fem_problem(), Comments::sentences); }},
  };
  return list;
}

ExitCode run_init(const Session& session) {
  const std::filesystem::path folder = session.out.empty() ? "." : session.out;
  for (const Starter& starter : starters())
    if (std::filesystem::exists(folder / starter.file))
      throw Error(ExitCode::bad_input, "the file is there already and is not overwritten",
                  {.file = (folder / starter.file).string()});
  make_writable_folder(folder);
  Json written = {{"schema", 1}};
  for (const Starter& starter : starters()) {
    write_file_atomically(folder / starter.file, starter.text());
    written[starter.file] = fmt::format("{} {}", starter.use, (folder / starter.file).string());
  }
  print_result(session, written);
  return ExitCode::done;
}

}  // namespace

Action declare_init(CLI::App& command) {
  command.footer("Writes commented files to start from into --out (default: here).\n\n" +
                 exit_code_help());
  return run_init;
}

}  // namespace rebound
