#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/human_text.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/atlas/atlas_text.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

constexpr const char* default_folder = "results/atlas";

std::string atlas_help() {
  return "Keys of FILE (TOML), all optional; without FILE the default grid:\n" +
         help_text<AtlasGrid>() +
         fmt::format(
             "\nWrites atlas.json, atlas.csv, report.html and the FE impacts (impacts.sqlite) to "
             "--out (default {});\nimpacts found there are not run again.\n\n",
             default_folder) +
         exit_code_help();
}

/// The impact of the smallest contact, for which the one mesh of the grid is made.
FemProblem smallest_contact(const AtlasGrid& grid) {
  FemProblem smallest;
  double radius = std::numeric_limits<double>::infinity();
  for (const AtlasMaterial& material : materials_of(grid)) {
    const FemProblem problem =
        atlas_problem(grid, material, *std::min_element(grid.speeds.begin(), grid.speeds.end()));
    const double found =
        fem::expected_contact_radius(problem, fem::instantaneous_moduli(problem.material));
    if (found < radius) smallest = problem;
    radius = std::min(radius, found);
  }
  return smallest;
}

ExitCode run_atlas(const Session& session, const std::string& path) {
  AtlasGrid grid;
  std::string text;
  if (!path.empty()) {
    const Document document = Document::load(path);
    text = document.text();
    read_document(document, grid);
    try {
      check_grid(grid);
    } catch (const Error& error) {
      throw document.located(error);
    }
  }
  const std::filesystem::path out = session.out.empty() ? default_folder : session.out;
  make_writable_folder(out);
  const Atlas atlas = [&] {
    ProgressLine progress("atlas");
    const RunControl control = progress.control();
    const FemProblem smallest = smallest_contact(grid);
    return make_atlas(grid, fem_runner(mesh_for(smallest, control), smallest.sphere, control),
                      ImpactStore(out / "impacts.sqlite", write_toml(smallest)), control);
  }();
  Json json = to_json(atlas);
  write_file_atomically(out / "atlas.csv", to_csv(atlas));
  report::write_report(atlas_report(atlas), out / "report.html");
  Json stored = json;
  stored["provenance"] = to_json(provenance_of(session, path, text));
  write_file_atomically(out / "atlas.json", dump(stored));
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(fmt::format("{}\n{} impacts, {} run now in {}; maps in {}\n", to_text(atlas),
                           count_text(atlas.entries.size() * grid.speeds.size()),
                           count_text(static_cast<std::size_t>(atlas.impacts_run)),
                           duration_text(atlas.impact_seconds), (out / "report.html").string()));
  return ExitCode::done;
}

}  // namespace

Action declare_atlas(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Grid of the atlas; absent: the default grid");
  command.footer(atlas_help);
  return [file](const Session& session) { return run_atlas(session, *file); };
}

}  // namespace rebound
