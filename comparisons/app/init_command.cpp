#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/named_examples.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/dataset/guess_dataset.hpp"
#include "comparisons/io/toml/units.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct InitOptions {
  std::string what;
  std::string from;
  bool list = false;
  DatasetHints hints;
};

[[noreturn]] void refuse_overwriting(const std::filesystem::path& file) {
  throw Error(ExitCode::bad_input, "the file is there already and is not overwritten",
              {.file = file.string(), .key = {}, .value = {}, .allowed = {}});
}

/// A hint must be a quantity of its kind: a manifest is not to fail where its writer could have.
void check_hint(const char* option, const std::string& text, const Dimension& dimension) {
  if (text.empty()) return;
  try {
    if (parse_quantity(text, dimension) > 0.0) return;
  } catch (const Error& error) {
    throw Error(ExitCode::bad_input, error.what(),
                {.file = {}, .key = option, .value = text, .allowed = {}});
  }
  throw Error(ExitCode::bad_input, "the value must be positive",
              {.file = {}, .key = option, .value = text, .allowed = {}});
}

/// Copies by way of a temporary name, so that a file is there whole or not at all.
void copy_file_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::filesystem::path part = to.string() + ".part";
  std::error_code status;
  std::filesystem::copy_file(from, part, std::filesystem::copy_options::overwrite_existing, status);
  if (!status) std::filesystem::rename(part, to, status);
  if (!status) return;
  const std::string reason = status.message();
  std::filesystem::remove(part, status);
  throw Error(ExitCode::input_output_failed, "the file cannot be copied: " + reason,
              {.file = to.string(), .key = {}, .value = {}, .allowed = {}});
}

/// Data sets around a file of measurements: the file beside a manifest full of marked guesses.
ExitCode run_init_dataset(const Session& session, const InitOptions& options) {
  check_hint("--mass", options.hints.mass, dimension::mass);
  check_hint("--diameter", options.hints.diameter, dimension::length);
  check_hint("--speed", options.hints.speed, dimension::speed);
  const std::filesystem::path source = options.from;
  const auto datasets = guess_dataset(source, options.hints);
  const std::filesystem::path out =
      session.out.empty() ? source.parent_path() / source.stem() : session.out;
  for (const GuessedDataset& dataset : datasets)
    for (const auto& name : {std::filesystem::path("dataset.toml"), source.filename()}) {
      const auto file = out / dataset.folder / name;
      std::error_code status;
      const bool itself = std::filesystem::equivalent(file, source, status);
      if (std::filesystem::exists(file) && !itself) refuse_overwriting(file);
    }
  Json written = {{"schema", 1}};
  for (const GuessedDataset& dataset : datasets) {
    const auto folder = (out / dataset.folder).lexically_normal();
    make_writable_folder(folder);
    std::error_code status;
    if (!std::filesystem::equivalent(folder / source.filename(), source, status))
      copy_file_whole(source, folder / source.filename());
    write_file_atomically(folder / "dataset.toml", dataset.manifest);
    const auto open = dataset.manifest.find("= \"?\"") != std::string::npos;
    written[(folder / "dataset.toml").string()] =
        open ? "guessed; fill in what is marked \"?\", then `rebound inspect`"
             : "guessed; look at what is marked, then `rebound inspect`";
  }
  print_result(session, written);
  return ExitCode::done;
}

/// The names of the examples, a line each.
ExitCode list_examples(const Session& session) {
  Json listed = {{"schema", 1}};
  for (const NamedExample& example : named_examples()) listed[example.name] = example.shows;
  print_result(session, listed);
  return ExitCode::done;
}

/// Writes files to start from; none of them where one is there already.
Json write_examples(const std::filesystem::path& folder, const std::vector<ExampleFile>& files) {
  for (const ExampleFile& example : files)
    if (std::filesystem::exists(folder / example.file)) refuse_overwriting(folder / example.file);
  Json written = {{"schema", 1}};
  for (const ExampleFile& example : files) {
    const std::filesystem::path file = folder / example.file;
    make_writable_folder(file.parent_path());
    write_file_atomically(file, example.text());
    written[file.string()] = example.use;
  }
  return written;
}

/// The files of one example, and what to do with them.
ExitCode run_named(const Session& session, const NamedExample& example,
                   const std::filesystem::path& folder) {
  std::vector<ExampleFile> files;
  for (const ExampleFile& file : example_files())
    if (std::find(example.files.begin(), example.files.end(), file.file) != example.files.end())
      files.push_back(file);
  Json written = write_examples(folder, files);
  const auto next = commands_in(example, folder);
  if (session.json()) written["next"] = next;
  print_result(session, written);
  if (!session.json())
    for (const std::string& command : next) print_text(fmt::format("{:<28}{}\n", "next", command));
  return ExitCode::done;
}

ExitCode run_init(const Session& session, const InitOptions& options) {
  if (options.list) return list_examples(session);
  const bool dataset = options.what == "dataset";
  if (!options.from.empty() && (dataset || options.what.empty()))
    return run_init_dataset(session, options);
  if (dataset)
    throw Error(ExitCode::bad_input, "which file is the data set made from?",
                {.file = {},
                 .key = "--from",
                 .value = {},
                 .allowed = "init dataset --from FILE.csv, .mat or .h5"});
  const std::filesystem::path folder = session.out.empty() ? "." : session.out;
  if (!options.what.empty()) {
    const NamedExample& example = named_example(options.what);
    if (!options.from.empty())
      throw Error(ExitCode::bad_input, "this belongs to `init dataset`, an example has none",
                  {.key = "--from", .value = options.from});
    return run_named(session, example, folder);
  }
  print_result(session, write_examples(folder, example_files()));
  return ExitCode::done;
}

}  // namespace

Action declare_init(CLI::App& command) {
  const auto options = std::make_shared<InitOptions>();
  std::string names = "dataset";
  for (const NamedExample& example : named_examples()) names += "," + example.name;
  // In braces as CLI11 writes a choice, for completions; a misspelt name is refused by the action.
  command
      .add_option("WHAT", options->what,
                  "An example's name: its files alone. dataset: a data set around a file of "
                  "measurements")
      ->type_name("TEXT:{" + names + "}");
  command.add_flag("--list", options->list, "Print the examples, and what each shows");
  command.add_option("--from", options->from,
                     "File of a recorder or a spreadsheet: text, .mat or HDF5");
  command.add_option("--mass", options->hints.mass, "Of the ball, e.g. \"89.6 g\"");
  command.add_option("--diameter", options->hints.diameter, "Of the ball, e.g. \"66.2 mm\"");
  command.add_option("--speed", options->hints.speed, "Of a trace's impact, e.g. \"15 m/s\"");
  command.footer(
      "Writes commented files to start from into --out (default: here): all of them, or those of\n"
      "one example, `init diagnosis`, with the commands that use them; --list has the names.\n"
      "init dataset --from FILE writes a data set around a file into --out (default: a folder of "
      "the\n"
      "file's name beside it): a copy of the file and a manifest in which every guess is marked.\n"
      "Comma, semicolon or tabulator, decimal comma, units in the headings or below them; or\n"
      "variables of a MATLAB (.mat) or HDF5 (.h5) file. A time\n"
      "beside forces or accelerations is a trace, anything else a table of shots; a column of "
      "balls\n"
      "gives a folder a ball.\n\n" +
      exit_code_help());
  return [options](const Session& session) { return run_init(session, *options); };
}

}  // namespace rebound
