#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/config/document.hpp"
#include "comparisons/config/units.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "meshes/format/msh.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

struct MeshOptions {
  std::string file;
  std::string diameter;
  SphereMeshRequest request;
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
  if (options.file.empty() == options.diameter.empty())
    throw Error(ExitCode::bad_input, "give either a mesh FILE or --diameter");
  if (!options.file.empty()) {
    constexpr std::size_t largest_file = 1u << 28;
    return read_msh(read_text_file(options.file, largest_file), options.file);
  }
  SphereMeshRequest request = options.request;
  request.radius = 0.5 * length_of("--diameter", options.diameter);
  return generate_sphere_mesh(request);
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

ExitCode run_mesh(const Session& session, const MeshOptions& options) {
  const Mesh mesh = mesh_of(options);
  if (!session.out.empty()) {
    const bool is_file = session.out.extension() == ".msh";
    if (!is_file) make_writable_folder(session.out);
    write_file_atomically(is_file ? session.out : session.out / "sphere.msh", write_msh(mesh));
  }
  print_result(session, quality_json(measure_quality(mesh)));
  return ExitCode::done;
}

}  // namespace

Action declare_mesh(CLI::App& command) {
  const auto options = std::make_shared<MeshOptions>();
  command.add_option("FILE", options->file, "Check and measure this Gmsh mesh instead");
  command.add_option("--diameter", options->diameter, "Diameter of the sphere, e.g. \"66.2 mm\"");
  command.add_option("--cells", options->request.cells, "About how many cells")
      ->capture_default_str();
  command.add_option("--grading", options->request.grading,
                     "Cell size opposite the contact over that at it, 1 to 200; 30 for contacts "
                     "below a tenth of the radius")
      ->capture_default_str();
  command.footer("--out NAME.msh writes the mesh there, --out DIR to DIR/sphere.msh.\n\n" +
                 exit_code_help());
  return [options](const Session& session) { return run_mesh(session, *options); };
}

}  // namespace rebound
