#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/inference/selection/selection_file.hpp"
#include "comparisons/inference/selection/selection_text.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string select_help() {
  return "Keys of FILE (TOML):\n" + help_text<SelectionFile>() +
         "\nCandidates are ranked by BIC and AICc and by prediction of a left-out speed; several "
         "that stay are\nsaid to be not told apart. --out writes selection.json.\n\n" +
         exit_code_help();
}

ExitCode run_select(const Session& session, const std::string& path) {
  const Document document = Document::load(path);
  SelectionFile file;
  read_document(document, file);
  std::vector<MeasuredImpact> references;
  for (const auto& folder : file.references)
    for (auto& found : file.options.observable == Observable::scalars
                           ? read_scalar_references(document.folder() / folder.folder)
                           : read_references(document.folder() / folder.folder))
      references.push_back(std::move(found));
  if (!session.out.empty()) make_writable_folder(session.out);
  const Selection selection = [&] {
    ProgressLine progress("selection");
    try {
      return select_law(file.candidates, references, file.options, progress.control());
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  const Json json = to_json(selection);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "selection.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(selection));
  return selection.chosen.empty() ? ExitCode::solver_failed : ExitCode::done;
}

}  // namespace

Action declare_select(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Selection file: candidates, and what they are fitted to")
      ->required();
  command.footer(select_help);
  return [file](const Session& session) { return run_select(session, *file); };
}

}  // namespace rebound
