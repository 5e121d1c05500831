#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/trials/trial_report.hpp"
#include "comparisons/discrepancy/trials/trial_table.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct TrialsOptions {
  std::vector<std::string> folders, from_tables;
  std::string table;
  std::uint64_t seed = 1;
  std::size_t count = 0;
  bool ask_fem = false;
  bool mixed = false;
  bool fail_on_miss = false;
};

std::string trials_help() {
  return "FOLDER is what build/trial_generator wrote: data sets, believed models and sealed "
         "truths.\n"
         "Every data set is diagnosed; the truths are opened after the last one, and only where\n"
         "their bytes match their seals. Outcomes stand in FOLDER/outcomes (of one folder in "
         "--out\n"
         "where that is given), in one SQLite file a protocol (thresholds, version and digest of\n"
         "the program, seed), by the digest of the trial's files: a run that was stopped or\n"
         "killed goes on where it was, and two may run at a time. Outcomes of two protocols are\n"
         "refused before the first diagnosis; --mixed takes them, and says so.\n"
         "\n"
         "trials.json and report.html go to --out (default FOLDER/outcomes; results/trials of\n"
         "several folders): every share with its Wilson interval and what is asked of it, power\n"
         "over size and noise, confusion by family and by name, and beside the diagnosis three\n"
         "controls: the lowest BIC without abstention, a sparse regression of the residual force,\n"
         "and a random answer.\n\n"
         "  build/trial_generator --out blind --count 100 --seed 7\n"
         "  build/rebound trials blind --table blind.csv\n"
         "  build/rebound trials --from-table blind.csv --out page\n\n"
         "Balls in finite elements are scored by themselves:\n\n"
         "  build/trial_generator --out bodies --count 20 --seed 7 --fem build/rebound\n"
         "  build/rebound trials bodies --ask-fem\n\n" +
         exit_code_help();
}

void check_options(const TrialsOptions& options) {
  if (options.folders.empty() == options.from_tables.empty())
    throw Error(ExitCode::bad_input, "needs folders of trials, or a table of them",
                {.key = "FOLDER", .allowed = "FOLDER ..., or --from-table FILE ..."});
  if (!options.from_tables.empty() && !options.table.empty())
    throw Error(ExitCode::bad_input, "would write the table that it reads",
                {.key = "--table", .value = options.table, .allowed = "without --from-table"});
  if (options.ask_fem && !has_fem_tier())
    throw Error(ExitCode::bad_input, "needs the FE tier, which was not built",
                {.key = "--ask-fem", .allowed = "a build with -DREBOUND_FEM=ON"});
}

/// Where scores are written; empty: nowhere.
std::filesystem::path scores_folder(const Session& session, const TrialsOptions& options) {
  if (!session.out.empty() || options.folders.empty()) return session.out;
  if (options.folders.size() > 1) return std::filesystem::path("results") / "trials";
  return std::filesystem::path(options.folders.front()) / "outcomes";
}

TrialRun run_of(const Session& session, const TrialsOptions& options) {
  TrialRun run{
      .folders = {}, .seed = options.seed, .ask_fem = options.ask_fem, .mixed = options.mixed};
  if (options.count > 0) run.most = options.count;
  for (const std::string& folder : options.folders) {
    const bool alone = options.folders.size() == 1 && !session.out.empty();
    run.folders.push_back(
        {.data = folder,
         .outcomes = alone ? session.out : std::filesystem::path(folder) / "outcomes"});
  }
  return run;
}

ExitCode print_progress(const Session& session, const TrialProgress& progress) {
  if (session.json())
    fmt::print("{}", dump({{"schema", 1},
                           {"complete", false},
                           {"outcomes", progress.with_outcome},
                           {"trials", progress.trials}}));
  else
    fmt::print("{} of {} trials have their outcome; no truth is opened before the last\n",
               progress.with_outcome, progress.trials);
  return ExitCode::done;
}

ExitCode write_scores(const Session& session, const TrialsOptions& options,
                      const TrialCollection& trials) {
  if (!options.table.empty()) write_file_atomically(options.table, table_csv(trials));
  const TrialScores scores = score_trials(trials);
  const Json json = to_json(scores);
  const std::filesystem::path out = scores_folder(session, options);
  if (!out.empty()) {
    make_writable_folder(out);
    Json stored = json;
    const std::string& input =
        (options.folders.empty() ? options.from_tables : options.folders).front();
    stored["provenance"] = to_json(provenance_of(session, input, ""));
    write_file_atomically(out / "trials.json", dump(stored));
    report::write_report(trial_report(scores), out / "report.html");
  }
  if (session.json()) {
    fmt::print("{}", dump(json));
  } else {
    print_text(to_text(scores));
    if (!out.empty()) fmt::print("\nreport    {}\n", (out / "report.html").string());
  }
  const auto misses = [](const TrialScores& of) {
    return std::any_of(of.gates.begin(), of.gates.end(),
                       [](const TrialGate& gate) { return gate.is_asked() && !gate.passes(); });
  };
  const bool only_in_fem = scores.in_fem && scores.trials == 0;
  const bool missed = (!only_in_fem && misses(scores)) || (scores.in_fem && misses(*scores.in_fem));
  return options.fail_on_miss && missed ? ExitCode::comparison_failed : ExitCode::done;
}

ExitCode run_trials_command(const Session& session, const TrialsOptions& options) {
  check_options(options);
  if (!options.from_tables.empty())
    return write_scores(session, options, read_trial_tables(options.from_tables, options.mixed));
  const TrialRun run = run_of(session, options);
  const TrialProgress progress = [&] {
    ProgressLine line("trials");
    return run_trials(run, line.control());
  }();
  if (!progress.complete()) return print_progress(session, progress);
  return write_scores(session, options, open_trials(run));
}

}  // namespace

Action declare_trials(CLI::App& command) {
  const auto options = std::make_shared<TrialsOptions>();
  command.add_option("FOLDER", options->folders,
                     "Trials as the generator wrote them; several are scored together");
  command.add_option("--table", options->table, "Write all trials with their outcomes as CSV");
  command.add_option("--from-table", options->from_tables,
                     "Score such CSVs again, without trials or truths; several together");
  command
      .add_option("--count", options->count,
                  "Diagnose at most so many now; the same command goes on with the rest")
      ->check(CLI::Range(1, 1'000'000));
  command.add_option("--seed", options->seed, "Seed of the draws behind the thresholds");
  command.add_flag("--ask-fem", options->ask_fem,
                   "Let a diagnosis ask FE, for balls in finite elements (trial_generator --fem); "
                   "a part of the protocol");
  command.add_flag("--mixed", options->mixed,
                   "Take outcomes of several thresholds or programs together, and say so");
  command.add_flag("--fail-on-miss", options->fail_on_miss, "Exit 1 when a gate is not met");
  command.footer(trials_help);
  return [options](const Session& session) { return run_trials_command(session, *options); };
}

}  // namespace rebound
