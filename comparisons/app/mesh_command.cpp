#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "comparisons/accuracy/verification/mesh_comparison.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/interruption.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

struct MeshOptions {
  std::string file;
  std::string diameter;
  SphereMeshRequest request;
  bool unstructured = false, lower_half = false, compare = false;
};

double length_of(const std::string& option, const std::string& text) {
  try {
    return parse_quantity(text, dimension::length);
  } catch (const Error& error) {
    throw Error(error.code(), error.what(),
                {.key = option, .value = text, .allowed = "a length such as \"66.2 mm\""});
  }
}

Mesh mesh_of(const MeshOptions& options) {
  const RunControl control{.interrupted = interrupted, .progress = {}};
  if (options.file.empty() == options.diameter.empty())
    throw Error(ExitCode::bad_input, "give either a mesh FILE or --diameter");
  if (!options.file.empty())
    return gmsh_module().read(options.file, options.request.cells, control);
  SphereMeshRequest request = options.request;
  request.radius = 0.5 * length_of("--diameter", options.diameter);
  if (options.lower_half) request.part = SpherePart::lower_half;
  return options.unstructured ? gmsh_module().sphere(request, control)
                              : generate_sphere_mesh(request);
}

Json quality_json(const MeshQuality& quality) {
  return {{"schema", 1},
          {"cells", quality.cells},
          {"vertices", quality.vertices},
          {"smallest_edge_m", quality.smallest_edge},
          {"largest_edge_m", quality.largest_edge},
          {"contact_edge_length_m", quality.contact_edge_length},
          {"worst_scaled_jacobian", quality.worst_scaled_jacobian},
          {"volume_m3", quality.volume}};
}

/// Cells of each region, where the mesh has any.
Json regions_json(const Mesh& mesh) {
  Json regions = Json::object();
  for (std::size_t i = 0; i < mesh.region_names.size(); ++i)
    regions[mesh.region_names[i]] =
        std::count(mesh.regions.begin(), mesh.regions.end(), static_cast<int>(i));
  return regions;
}

ExitCode run_comparison(const Session& session, const MeshOptions& options) {
  if (!session.out.empty()) make_writable_folder(session.out);
  const auto outcomes = [&] {
    ProgressLine progress("Meshes");
    return compare_meshes(fem_tier(), gmsh_module(), options.request.cells, progress.control());
  }();
  const Json json = to_json(outcomes);
  if (!session.out.empty()) write_file_atomically(session.out / "mesh_comparison.json", dump(json));
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(outcomes));
  return ExitCode::done;
}

ExitCode run_mesh(const Session& session, const MeshOptions& options) {
  if (options.compare) return run_comparison(session, options);
  const Mesh mesh = mesh_of(options);
  if (!session.out.empty()) {
    const bool is_file = session.out.extension() == ".msh";
    if (!is_file) make_writable_folder(session.out);
    write_file_atomically(is_file ? session.out : session.out / "sphere.msh",
                          gmsh_module().msh(mesh));
  }
  Json json = quality_json(measure_quality(mesh));
  if (!mesh.region_names.empty()) json["regions"] = regions_json(mesh);
  print_result(session, json);
  return ExitCode::done;
}

}  // namespace

Action declare_mesh(CLI::App& command) {
  const auto options = std::make_shared<MeshOptions>();
  command.add_option(
      "FILE", options->file,
      "Check and measure this file instead: .msh of any version, .geo, .step or .stp");
  command.add_option("--diameter", options->diameter, "Diameter of the sphere, e.g. \"66.2 mm\"");
  command
      .add_option("--cells", options->request.cells, "About how many cells; of a .step file too")
      ->capture_default_str();
  command
      .add_option("--grading", options->request.grading,
                  "Cell size opposite the contact over that at it, 1 to 200; 30 for contacts "
                  "below a tenth of the radius")
      ->capture_default_str();
  command.add_flag("--lower-half", options->lower_half,
                   "The lower half, as a compression between two platens takes it");
  command.add_flag("--unstructured", options->unstructured,
                   "Gmsh's quadrilaterals instead of mapped blocks, graded up to 100");
  command.add_flag(
      "--compare", options->compare,
      "Run the impact that the choice of mapped blocks rests on, on both kinds of mesh: "
      "a quarter of --cells, --cells and four times as many");
  command.footer(
      "--out NAME.msh writes the mesh there (MSH 4.1, binary), --out DIR to DIR/sphere.msh; with "
      "--compare\nDIR/mesh_comparison.json.\n\n" +
      exit_code_help());
  return [options](const Session& session) { return run_mesh(session, *options); };
}

}  // namespace rebound
