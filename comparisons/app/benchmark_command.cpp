#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/audit_option.hpp"
#include "comparisons/app/calibration_text.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/benchmark/benchmark_file.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string benchmark_help() {
  return "Keys of FILE (TOML):\n" + help_text<BenchmarkFile>() +
         "\n--out writes benchmark.json; with --audit audit.json.\n\n" + exit_code_help();
}

BenchmarkEntry entry_of(const Document& document, const BenchmarkRow& row,
                        const std::vector<MeasuredImpact>& shots, const RunControl& control) {
  if (!row.file.empty()) return {row.label, read_lumped_file(document.folder() / row.file).model};
  try {
    return {row.label, calibrate(row.request, shots, {}, control).model};
  } catch (const Error& error) {
    throw document.located(error);
  }
}

ExitCode run_benchmark(const Session& session, const std::string& path) {
  const Document document = Document::load(path);
  BenchmarkFile file;
  read_document(document, file);
  std::vector<MeasuredImpact> references;
  for (const auto& folder : file.references)
    for (auto& found : read_references(document.folder() / folder.folder))
      references.push_back(std::move(found));
  if (!session.out.empty()) make_writable_folder(session.out);
  const BenchmarkMatrix matrix = [&] {
    ProgressLine progress("benchmark");
    std::vector<BenchmarkEntry> entries;
    for (const auto& row : file.rows)
      entries.push_back(entry_of(document, row, references, progress.control()));
    return benchmark(entries, references, progress.control());
  }();
  Json json = {{"schema", 1}};
  json.update(to_json(matrix));
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "benchmark.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(matrix));
  return ExitCode::done;
}

}  // namespace

Action declare_benchmark(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  const auto audit = std::make_shared<bool>(false);
  const auto speeds = std::make_shared<std::vector<double>>(std::vector<double>{5.0, 15.0, 25.0});
  command.add_flag("--audit", *audit,
                   "Audit the paper's assumptions instead; FILE is then an FE impact file");
  command.add_option("--speeds", *speeds, "Speeds of the audit in m/s, ascending")
      ->capture_default_str();
  command.add_option("FILE", *file, "Benchmark file: laws, and what they are scored against")
      ->required();
  command.footer(benchmark_help);
  return [=](const Session& session) {
    return *audit ? run_audit_option(session, *file, *speeds) : run_benchmark(session, *file);
  };
}

}  // namespace rebound
