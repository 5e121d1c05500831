#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/inspection/inspection_output.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct InspectOptions {
  std::string folder;
  bool fail_on_contradiction = false;
};

ExitCode run_inspect(const Session& session, const InspectOptions& options) {
  const Dataset dataset = read_dataset(options.folder);
  const Inspection inspection = inspect(dataset);
  Json json = to_json(inspection);
  if (!session.out.empty()) {
    make_writable_folder(session.out);
    const auto manifest = std::filesystem::path(options.folder) / "dataset.toml";
    report::write_report(inspection_report(inspection, dataset), session.out / "report.html");
    json["report"] = (session.out / "report.html").string();
    Json stored = json;
    stored["provenance"] =
        to_json(provenance_of(session, manifest.string(), read_text_file(manifest)));
    write_file_atomically(session.out / "inspection.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(inspection));
  const bool failed = options.fail_on_contradiction && !inspection.contradictions.empty();
  return failed ? ExitCode::comparison_failed : ExitCode::done;
}

}  // namespace

Action declare_inspect(CLI::App& command) {
  const auto options = std::make_shared<InspectOptions>();
  command.add_option("DATASET", options->folder, "Data-set folder")->required();
  command.add_flag("--fail-on-contradiction", options->fail_on_contradiction,
                   "Exit 1 when the data contradict themselves");
  command.footer(
      "Looks at a data set without any model: numbers of every record with their uncertainties,\n"
      "noise and its colour, impulse and energy, what contradicts what, what is too coarse, and\n"
      "what the filters of SAE J211 would do to the peaks.\n"
      "--out DIR writes report.html and inspection.json.\n\n" +
      exit_code_help());
  return [options](const Session& session) { return run_inspect(session, *options); };
}

}  // namespace rebound
