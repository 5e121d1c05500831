#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct TrialsOptions {
  std::string folder;
  std::uint64_t seed = 1;
  bool fail_on_miss = false;
};

std::string trials_help() {
  return "FOLDER is what build/trial_generator wrote: data sets, believed models and sealed "
         "truths.\n"
         "Every data set is diagnosed; the truths are opened after the last one, and only where\n"
         "their bytes match their seals. Outcomes stand in --out (default FOLDER/outcomes), one\n"
         "file a trial: a run that was stopped goes on where it was. Beside them: trials.json and\n"
         "report.html with every share, its Wilson interval and what is asked of it.\n\n"
         "  build/trial_generator --out blind --count 100 --seed 7\n"
         "  build/rebound trials blind\n\n" +
         exit_code_help();
}

ExitCode run_trials_command(const Session& session, const TrialsOptions& options) {
  const std::filesystem::path folder = options.folder;
  const std::filesystem::path out = session.out.empty() ? folder / "outcomes" : session.out;
  const std::vector<TrialOutcome> outcomes = [&] {
    ProgressLine progress("trials");
    return run_trials({.folder = folder, .outcomes = out, .seed = options.seed},
                      progress.control());
  }();
  const TrialScores scores = score_trials(outcomes, read_truths(folder));
  const Json json = to_json(scores);
  Json stored = json;
  stored["provenance"] = to_json(provenance_of(session, options.folder, ""));
  write_file_atomically(out / "trials.json", dump(stored));
  report::write_report(trial_report(scores), out / "report.html");
  if (session.json())
    fmt::print("{}", dump(json));
  else
    fmt::print("{}\nreport    {}\n", to_text(scores), (out / "report.html").string());
  const bool missed = std::any_of(scores.gates.begin(), scores.gates.end(),
                                  [](const TrialGate& gate) { return !gate.passes(); });
  return options.fail_on_miss && missed ? ExitCode::comparison_failed : ExitCode::done;
}

}  // namespace

Action declare_trials(CLI::App& command) {
  const auto options = std::make_shared<TrialsOptions>();
  command.add_option("FOLDER", options->folder, "Trials as the generator wrote them")->required();
  command.add_option("--seed", options->seed, "Seed of the draws behind the thresholds");
  command.add_flag("--fail-on-miss", options->fail_on_miss, "Exit 1 when a gate is missed");
  command.footer(trials_help);
  return [options](const Session& session) { return run_trials_command(session, *options); };
}

}  // namespace rebound
