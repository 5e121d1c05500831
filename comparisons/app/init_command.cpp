#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/examples.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/problem/atomic_file.hpp"

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
      {"lumped.toml", "an impact for `rebound lumped`",
       [] { return write_toml(example_lumped_problem(), Comments::sentences); }},
      {"fem.toml", "an impact for `rebound fem`",
       [] { return write_toml(example_fem_problem(), Comments::sentences); }},
      {"compression.toml", "a slow compression between platens for `rebound compress`",
       [] { return write_toml(example_compression(), Comments::sentences); }},
      {"synthesis.toml", "an experiment for `rebound synthesize`, with something hidden in it",
       [] { return write_toml(example_synthesis(), Comments::sentences); }},
      {"dataset/dataset.toml", "the data set of a study; its CSV files go beside it",
       [] { return write_toml(example_dataset(), Comments::sentences); }},
      {"calibrate.toml",
       "a fit for `rebound calibrate`, once `rebound lumped lumped.toml --out reference` has run",
       [] { return write_toml(example_calibration(), Comments::sentences); }},
      {"select.toml", "two laws for `rebound select`, on the same reference",
       [] { return write_toml(example_selection(), Comments::sentences); }},
      {"benchmark.toml", "two laws for `rebound benchmark`, on the same reference",
       [] { return write_toml(example_benchmark(), Comments::sentences); }},
  };
  return list;
}

ExitCode run_init(const Session& session) {
  const std::filesystem::path folder = session.out.empty() ? "." : session.out;
  for (const Starter& starter : starters())
    if (std::filesystem::exists(folder / starter.file))
      throw Error(ExitCode::bad_input, "the file is there already and is not overwritten",
                  {.file = (folder / starter.file).string()});
  Json written = {{"schema", 1}};
  for (const Starter& starter : starters()) {
    const std::filesystem::path file = folder / starter.file;
    make_writable_folder(file.parent_path());
    write_file_atomically(file, starter.text());
    written[file.string()] = starter.use;
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
