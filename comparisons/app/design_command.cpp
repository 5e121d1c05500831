#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/design/design_output.hpp"
#include "comparisons/discrepancy/design/planned_experiments.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct DesignOptions {
  std::string path, effect;
  std::uint64_t seed = 1;
  int experiments = 0;
};

void check_options(const DesignOptions& options) {
  if (options.effect.empty()) return;
  find_effect(options.effect);
  if (options.experiments == 0)
    throw Error(ExitCode::bad_input, "no experiments are made, so that none holds the effect",
                {.key = "--effect", .value = options.effect, .allowed = "with --experiments N"});
}

std::vector<CountedChance> count_experiments(const SynthesisFile& plan, const TestDesign& design,
                                             const DesignOptions& options) {
  if (options.experiments == 0) return {};
  PlannedExperiments wanted{.experiments = options.experiments, .seed = options.seed};
  if (!options.effect.empty()) wanted.effect = options.effect;
  ProgressLine progress("experiments of the plan");
  return count_chances(plan, design, wanted, progress.control());
}

ExitCode run_design(const Session& session, const DesignOptions& options) {
  check_options(options);
  const Document document = Document::load(options.path);
  const SynthesisFile plan = read_synthesis(document);
  if (!session.out.empty()) make_writable_folder(session.out);
  TestDesign design;
  {
    ProgressLine progress("design of a test");
    const RunControl control = progress.control();
    document.locating([&] { design = design_test(plan, options.seed, control); });
  }
  const std::vector<CountedChance> counted = count_experiments(plan, design, options);
  Json json = to_json(design, counted);
  if (!session.out.empty()) {
    report::write_report(design_report(design, counted, plan.name), session.out / "report.html");
    json["report"] = (session.out / "report.html").string();
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, options.path, document.text()));
    write_file_atomically(session.out / "design.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(design, counted));
  return ExitCode::done;
}

}  // namespace

Action declare_design(CLI::App& command) {
  const auto options = std::make_shared<DesignOptions>();
  command.add_option("FILE", options->path, "Synthesis file without effects: the plan")->required();
  command.add_option("--seed", options->seed, "Seed of the draws behind chances and thresholds");
  command
      .add_option("--experiments", options->experiments,
                  "Make so many experiments of each size that is found with a chance of 0.2, 0.5 "
                  "and 0.9, diagnose them, and count")
      ->check(CLI::Range(1, 100'000));
  command.add_option("--effect", options->effect, "Hide this effect alone in the experiments");
  command.footer(
      "Says, before a test is made, which missing effects it would find and from which size on,\n"
      "which it could not tell apart, and what change of the plan would help most. FILE is what\n"
      "`rebound synthesize` takes, with no effect in it: ball, law or FE model, speeds, repeats,\n"
      "instrument. Its model is the one that is believed.\n"
      "--experiments N shows whether the chances hold: it hides effects in N synthetic\n"
      "experiments of the plan, diagnoses each, and prints what was predicted beside what was\n"
      "counted, with 95 % intervals. A diagnosis takes about a second of a lumped model, and half\n"
      "a minute of one in FE.\n"
      "--out DIR writes report.html and design.json.\n\n"
      "Keys of FILE (TOML):\n" +
      help_text<SynthesisFile>() + "\n" + exit_code_help());
  return [=](const Session& session) { return run_design(session, *options); };
}

}  // namespace rebound
