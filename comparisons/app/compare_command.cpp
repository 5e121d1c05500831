#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "comparisons/accuracy/tier_comparison/comparison_output.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct CompareOptions {
  std::string file;
  std::string baseline;
  bool record = false;
};

std::string compare_help() {
  return "Sets the lumped tier against FE, and either against a stored baseline. A change counts "
         "when\n"
         "it is larger than the numerical errors that the two runs do not share; nothing is to be\n"
         "chosen. Exit 1 says that a tier has moved, or that a gap is larger than the case "
         "allows.\n"
         "--out DIR writes report.html and comparison.json.\n\nKeys of FILE (TOML):\n" +
         help_text<CompareFile>() + "\n" + exit_code_help();
}

std::vector<CaseComparison> compare_all(const CompareFile& file, const Document& document,
                                        const CompareOptions& options) {
  std::vector<CaseComparison> comparisons;
  // Before anything is run: what is missing is said at once.
  std::vector<std::vector<TierRecord>> baselines(file.cases.size());
  if (!options.baseline.empty() && !options.record)
    for (std::size_t i = 0; i < file.cases.size(); ++i)
      baselines[i] = read_baseline(options.baseline, file.cases[i].name);
  ProgressLine progress("comparison");
  for (std::size_t i = 0; i < file.cases.size(); ++i)
    comparisons.push_back(
        compare_case(file.cases[i], run_case(file.cases[i], document.folder(), progress.control()),
                     baselines[i]));
  return comparisons;
}

ExitCode run_compare(const Session& session, const CompareOptions& options) {
  if (options.record && options.baseline.empty())
    throw Error(ExitCode::bad_input, "where are the baselines to go?",
                {.file = {}, .key = "--baseline", .value = {}, .allowed = "a folder"});
  const Document document = Document::load(options.file);
  const CompareFile file = read_compare_file(document);
  if (!session.out.empty()) make_writable_folder(session.out);
  if (options.record) make_writable_folder(options.baseline);
  const std::vector<CaseComparison> comparisons = compare_all(file, document, options);
  if (options.record)
    for (const CaseComparison& one : comparisons)
      write_baseline(options.baseline, one.name, one.records);
  Json json = to_json(comparisons);
  if (!session.out.empty()) {
    report::write_report(comparison_report(comparisons), session.out / "report.html");
    json["report"] = (session.out / "report.html").string();
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, options.file, document.text()));
    write_file_atomically(session.out / "comparison.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(comparisons));
  return json["passes"].get<bool>() ? ExitCode::done : ExitCode::comparison_failed;
}

}  // namespace

Action declare_compare(CLI::App& command) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("FILE", options->file, "Compare file: cases in one tier or both")->required();
  command.add_option("--baseline", options->baseline, "Folder of baselines, one file a case");
  command.add_flag("--record", options->record, "Write the baselines anew instead of comparing");
  command.footer(compare_help);
  return [options](const Session& session) { return run_compare(session, *options); };
}

}  // namespace rebound
