#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/interruption.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/config/describe_fem.hpp"
#include "comparisons/config/help_writer.hpp"
#include "comparisons/config/impact_file.hpp"
#include "comparisons/config/toml_writer.hpp"
#include "comparisons/modules/mesh_cache.hpp"
#include "comparisons/modules/module_loader.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/results/result_folder.hpp"
#include "meshes/format/msh.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

std::string fem_help() {
  return "Keys of FILE (TOML):\n" + help_text<FemImpactFile>() + "\n" + exit_code_help();
}

/// A user's mesh in millimetres, or of another ball, would run and mislead.
void check_size(const FemProblem& problem, const Mesh& mesh) {
  constexpr double tolerance = 0.05;  // of the volume: straight cell edges cut some off
  const double volume = measure_quality(mesh).volume;
  const double sphere = problem.sphere.volume();
  if (std::abs(volume / sphere - 1.0) <= tolerance) return;
  throw Error(ExitCode::bad_input,
              fmt::format("the mesh turned about its axis has {:.4g} m^3, the sphere of "
                          "sphere.diameter {:.4g} m^3; coordinates are in metres",
                          volume, sphere),
              {.file = problem.mesh_file, .key = "model.mesh", .allowed = "a volume within 5 %"});
}

Mesh mesh_for(const FemProblem& problem) {
  if (!problem.mesh_file.empty()) {
    constexpr std::size_t largest_file = 1u << 28;
    const Mesh mesh = read_msh(read_text_file(problem.mesh_file, largest_file), problem.mesh_file);
    check_size(problem, mesh);
    return mesh;
  }
  CachedMesh cached = sphere_mesh({.radius = problem.sphere.radius(), .cells = problem.cells});
  if (!cached.note.empty()) fmt::print(stderr, "rebound: {}\n", cached.note);
  return std::move(cached.mesh);
}

void prepare_output(const Session& session, const Document& document, FemProblem& problem) {
  if (!session.out.empty()) make_writable_folder(session.out);
  if (problem.controls.field_frames == 0) return;
  if (session.out.empty())
    throw document.error_at("controls.field_frames", "fields need a folder to go to: give --out");
  const auto fields = session.out / "fields";
  make_writable_folder(fields);
  problem.controls.field_directory = fields.string();
}

FemResult simulate_located(const Document& document, const FemProblem& problem, const Mesh& mesh) {
  ProgressLine progress("FE impact");
  try {
    return fem_tier().simulate(problem, mesh, progress.control());
  } catch (const Error& error) {
    throw document.located(error);
  }
}

ExitCode run_fem(const Session& session, const std::string& file) {
  const Document document = Document::load(file);
  const FemImpactFile impact_file = read_fem_impact(document);
  FemProblem problem = applied(impact_file, document);
  prepare_output(session, document, problem);
  const FemResult result = simulate_located(document, problem, mesh_for(problem));
  if (!session.out.empty()) {
    Provenance provenance = provenance_of(session, file, document.text());
    provenance.modules = {fem_tier().versions()};
    write_result({.folder = session.out,
                  .effective_toml = write_toml(impact_file),
                  .provenance = provenance},
                 result);
  }
  if (!result.incomplete_because.empty()) {
    const std::string kept =
        session.out.empty() ? "" : fmt::format("; what is known is in {}", session.out.string());
    throw Error(interrupted() ? ExitCode::interrupted : ExitCode::solver_failed,
                result.incomplete_because + kept, {.file = file});
  }
  print_result(session, to_json(result));
  return ExitCode::done;
}

}  // namespace

Action declare_fem(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Impact file with [model] tier = \"fem\"")->required();
  command.footer(fem_help);
  return [file](const Session& session) { return run_fem(session, *file); };
}

}  // namespace rebound
