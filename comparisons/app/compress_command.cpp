#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <utility>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/io/results/result_folder.hpp"
#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string compress_help() {
  return "Keys of FILE (TOML):\n" + help_text<CompressionProblem>() + "\n" + exit_code_help();
}

ExitCode run_compress(const Session& session, const std::string& file) {
  const Document document = Document::load(file);
  const CompressionProblem problem = read_compression(document);
  if (!session.out.empty()) make_writable_folder(session.out);
  CompressionResult result;
  try {
    ProgressLine progress("Compression");
    const RunControl control = progress.control();
    result = fem_tier().compress(problem, mesh_for(problem, control), control);
  } catch (const Error& error) {
    throw document.located(error);
  }
  if (!session.out.empty())
    write_result({.folder = session.out,
                  .effective_toml = write_toml(problem),
                  .provenance = provenance_with_fem(session, file, document.text())},
                 result);
  require_complete(session, file, result.incomplete_because);
  print_result(session, to_json(result));
  return ExitCode::done;
}

}  // namespace

Action declare_compress(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Compression file: [compression], [sphere], [model]")
      ->required();
  command.footer(compress_help);
  return [file](const Session& session) { return run_compress(session, *file); };
}

}  // namespace rebound
