#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/config/describe_compression.hpp"
#include "comparisons/config/help_writer.hpp"
#include "comparisons/config/toml_writer.hpp"
#include "comparisons/modules/module_loader.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/results/result_folder.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

std::string compress_help() {
  return "Keys of FILE (TOML):\n" + help_text<CompressionProblem>() + "\n" + exit_code_help();
}

/// The lower half between two platens, the whole on one plate; fine over the
/// contact radius √(R δ) of Hertz, δ the approach of one plate.
Mesh mesh_for(const CompressionProblem& problem) {
  const bool half = problem.compression.platens == 2;
  const double radius = problem.sphere.radius();
  const double approach = problem.compression.deflection * (half ? 0.5 : 1.0);
  return generate_sphere_mesh({.radius = radius,
                               .cells = problem.cells,
                               .grading = std::clamp(0.3 * radius / approach, 1.5, 200.0),
                               .part = half ? SpherePart::lower_half : SpherePart::whole});
}

ExitCode run_compress(const Session& session, const std::string& file) {
  const Document document = Document::load(file);
  const CompressionProblem problem = read_compression(document);
  if (!session.out.empty()) make_writable_folder(session.out);
  CompressionResult result;
  try {
    ProgressLine progress("Compression");
    result = fem_tier().compress(problem, mesh_for(problem), progress.control());
  } catch (const Error& error) {
    throw document.located(error);
  }
  if (!session.out.empty()) {
    Provenance provenance = provenance_of(session, file, document.text());
    provenance.modules = {fem_tier().versions()};
    write_result({.folder = session.out,
                  .effective_toml = write_toml(problem),
                  .provenance = provenance},
                 result);
  }
  require_complete(session, file, result.incomplete_because);
  print_result(session, to_json(result));
  return ExitCode::done;
}

}  // namespace

Action declare_compress(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Compression file: [compression], [sphere], [model]")->required();
  command.footer(compress_help);
  return [file](const Session& session) { return run_compress(session, *file); };
}

}  // namespace rebound
