#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/evaluation/export/export_deck.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct ExportOptions {
  std::string file, target;
};

std::string export_help() {
  std::string targets;
  for (const ExportTarget& target : export_targets())
    targets += fmt::format("  {:<12}{}\n", target.name, target.code);
  return "Targets:\n" + targets +
         "\nThe head of a deck says what the code does otherwise; physics that it has no part for "
         "is refused.\nWithout --out the deck goes to standard output. --out NAME.inp (.feb, .k, "
         ".py) "
         "writes it there, --out DIR to DIR/impact.inp (.feb, .k, .py). The deck for FEniCSx is a "
         "script that prints\nrestitution, deflection and force: python3 impact.py\n\nKeys of FILE "
         "(TOML):\n" +
         help_text<FemImpactFile>() + "\n" + exit_code_help();
}

std::filesystem::path place_of(const Session& session, const ExportTarget& target) {
  if (session.out.empty() || session.out.extension() == target.extension) return session.out;
  for (const ExportTarget& other : export_targets())
    if (session.out.extension() == other.extension)
      throw Error(ExitCode::bad_input, "the name is that of another code's deck",
                  {.key = "--out",
                   .value = session.out.string(),
                   .allowed = fmt::format("NAME{} or a folder", target.extension)});
  make_writable_folder(session.out);
  return session.out / (std::string("impact") + target.extension);
}

ExitCode run_export(const Session& session, const ExportOptions& options) {
  const ExportTarget& target = export_target(options.target);
  const Document document = Document::load(options.file);
  const FemImpactFile file = read_fem_impact(document);
  const FemProblem problem =
      applied({.problem = file.problem, .effects = without_measurement(file.effects)}, document);
  const ExportedDeck deck = [&] {
    try {
      return export_deck(target, problem, mesh_for(problem));
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  const std::filesystem::path place = place_of(session, target);
  if (!place.empty()) write_file_atomically(place, deck.text);
  Json json = {{"schema", 1},
               {"to", target.name},
               {"nodes", deck.nodes},
               {"elements", deck.elements},
               {"end_time_s", deck.end_time},
               {"differences", deck.differences}};
  if (!place.empty())
    json["deck_file"] = place.string();
  else if (session.json())
    json["deck"] = deck.text;
  if (session.json()) {
    fmt::print("{}", dump(json));
    return ExitCode::done;
  }
  for (const std::string& difference : deck.differences)
    fmt::print(stderr, "rebound: {}: {}\n", target.name, difference);
  if (place.empty())
    fmt::print("{}", deck.text);
  else
    fmt::print("{}: {} elements, {} nodes, ends at {:.4g} ms\n", place.string(), deck.elements,
               deck.nodes, 1e3 * deck.end_time);
  return ExitCode::done;
}

}  // namespace

Action declare_export(CLI::App& command) {
  const auto options = std::make_shared<ExportOptions>();
  command.add_option("FILE", options->file, "Impact file with [model] tier = \"fem\"")->required();
  command.add_option("--to", options->target, "The code that is to read the deck")->required();
  command.footer(export_help);
  return [options](const Session& session) { return run_export(session, *options); };
}

}  // namespace rebound
