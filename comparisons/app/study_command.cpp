#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/interruption.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/results/result_folder.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/studies/reproduce/report_sections.hpp"
#include "comparisons/studies/study/believed_simulation.hpp"
#include "comparisons/studies/study/study_json.hpp"
#include "comparisons/studies/study/study_report.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

/// Result folder of every FE reference, as `rebound fem` would write it, so
/// that it can be run again on its own.
void write_core(const std::filesystem::path& folder, const CoreStudy& core,
                const Provenance& provenance) {
  for (const auto& shot : core.shots) {
    const auto place =
        folder / ("core-" + core.label) / fmt::format("fem-{:g}mps", shot.measured.impact.speed);
    std::filesystem::create_directories(place);
    write_result(
        {.folder = place, .effective_toml = write_toml(shot.problem), .provenance = provenance},
        shot.fem);
  }
}

std::string table_of(const std::vector<CoreStudy>& cores) {
  std::string text = fmt::format("{:<30} {:>6} {:>8} {:>8} {:>9} {:>8} {:>8} {:>9}\n", "law", "m/s",
                                 "e", "e meas", "t_c ms", "t meas", "F_max N", "F-t rms %");
  for (const auto& core : cores)
    for (std::size_t s = 0; s < core.shots.size(); ++s) {
      const auto& shot = core.shots[s];
      const auto row = [&](const std::string& law, const ImpactScalars& scalars,
                           const std::string& rms) {
        text +=
            fmt::format("{:<30} {:>6g} {:>8.3f} {:>8.3f} {:>9.3f} {:>8.3f} {:>8.0f} {:>9}\n",
                        core.label + "  " + law, shot.measured.impact.speed, scalars.restitution,
                        *shot.measured.restitution.value, 1e3 * scalars.contact_time,
                        1e3 * *shot.measured.contact_time.value, scalars.peak_force, rms);
      };
      row("FE", shot.fem.scalars, "");
      for (std::size_t l = 0; l < core.laws.size(); ++l) {
        const auto& cell = core.benchmark.cells[l][s];
        if (cell.failure.empty())
          row(core.laws[l].label, cell.scalars, fmt::format("{:.1f}", 100 * cell.force_time_rms));
        else
          text += fmt::format("{:<30} {:>6g} {}\n", core.label + "  " + core.laws[l].label,
                              shot.measured.impact.speed, cell.failure);
      }
    }
  return text;
}

struct StudyRun {
  const StudyFile& study;
  std::filesystem::path out;
  Provenance provenance;
  std::vector<report::Section> paper;        ///< what the printed numbers imply
  std::vector<CoreStudy> cores;              ///< those that are complete
  std::vector<ExperimentStudy> experiments;  ///< likewise
  std::optional<JointScalars> joint;         ///< of all cores, once all are complete
  bool complete = false;
};

report::Report report_of(const StudyRun& run) {
  report::Report page =
      study_report(run.study, run.cores, run.joint, run.experiments, run.paper, run.provenance);
  if (!run.complete)
    page.subtitle = fmt::format(
        "Unfinished: {} of {} balls so far, and {} of {} experiments. The rest is being computed, "
        "or the run was stopped; load the page again to see. {}",
        run.cores.size(), run.study.cores.size(), run.experiments.size(),
        run.study.experiments.size(), page.subtitle);
  return page;
}

/// Writes what is complete: after every core, so that an interruption keeps it.
Json write_study(const StudyRun& run) {
  Json json = study_json(run.study, run.cores, run.joint, run.experiments);
  const auto page = run.out / "report.html";
  json["report"] = page.string();
  json["provenance"] = to_json(run.provenance);
  // The pages it leads to are there before a reader can follow a link.
  for (const StudyPage& diagnosis : diagnosis_pages(run.cores, run.experiments, run.provenance))
    report::write_report(diagnosis.report, run.out / diagnosis.file);
  report::write_report(report_of(run), page);
  write_file_atomically(run.out / "study.json", dump(json));
  return json;
}

std::string complete_cores(const StudyRun& run) {
  if (run.cores.empty()) return "no core was complete";
  std::string labels;
  for (const auto& core : run.cores) labels += (labels.empty() ? "" : ", ") + core.label;
  return fmt::format("complete and kept in {}: core {}", run.out.string(), labels);
}

/// Side by side, since some of a diagnosis keeps one processor busy alone; each is written when it
/// ends, in the order of the file.
void run_experiments(StudyRun& run, const RunControl& control) {
  const std::size_t count = run.study.experiments.size();
  std::vector<bool> ended(count, false);
  std::mutex one_at_a_time;
  in_parallel(count, [&](std::size_t i) {
    ExperimentStudy one =
        study_experiment(run.study.experiments[i], {.interrupted = control.interrupted});
    const std::scoped_lock lock(one_at_a_time);
    ended[i] = true;
    const auto before =
        std::count(ended.begin(), ended.begin() + static_cast<std::ptrdiff_t>(i), true);
    run.experiments.insert(run.experiments.begin() + before, std::move(one));
    control.progress(static_cast<double>(run.experiments.size()) / static_cast<double>(count));
    write_study(run);
  });
}

Json run_cores(StudyRun& run) {
  ProgressLine progress("study");
  const RunControl whole = progress.control();
  // Of a core's work; measured.
  constexpr double experiment_share = 0.5, simulation_share = 1.8;
  const auto cores = static_cast<double>(run.study.cores.size());
  const double count = (1.0 + simulation_share) * cores +
                       experiment_share * static_cast<double>(run.study.experiments.size());
  try {
    for (std::size_t i = 0; i < run.study.cores.size(); ++i) {
      RunControl control = whole;
      control.progress = [&](double fraction) {
        whole.progress((static_cast<double>(i) + fraction) / count);
      };
      run.cores.push_back(study_core(run.study, run.study.cores[i], control));
      write_core(run.out, run.cores.back(), run.provenance);
      write_study(run);
      if (i == 0)
        progress.say(fmt::format("core {} is complete; the report so far, which grows: {}",
                                 run.cores.back().label, (run.out / "report.html").string()));
    }
    RunControl control = whole;
    control.progress = [&](double fraction) {
      whole.progress((cores + simulation_share * cores * fraction) / count);
    };
    run.joint = diagnose_simulation(run.study.fem, run.cores, control);
    write_study(run);
    control.progress = [&](double fraction) {
      const double before = (1.0 + simulation_share) * cores;
      whole.progress((before + (count - before) * fraction) / count);
    };
    run_experiments(run, control);
    run.complete = true;
    return write_study(run);
  } catch (const Error& error) {
    if (error.code() != ExitCode::interrupted) throw;
    throw Error(
        ExitCode::interrupted,
        fmt::format("interrupted; {}; the same command runs the study again", complete_cores(run)));
  }
}

ExitCode run_study(const Session& session, const std::string& file) {
  const Document document = Document::load(file);
  const StudyFile study = read_study(document);
  const std::filesystem::path out =
      session.out.empty() ? std::filesystem::path("results") / std::filesystem::path(file).stem()
                          : session.out;
  make_writable_folder(out);
  const Provenance provenance = provenance_with_fem(session, file, document.text());

  StudyRun run{study, out, provenance, {}, {}, {}, {}, false};
  if (!study.reproduce.empty()) run.paper = report_sections(reproduce(study.reproduce));
  const Json json = run_cores(run);
  if (session.json()) {
    print_result(session, json);
  } else {
    std::string text = table_of(run.cores) + "\n";
    for (const auto& core : run.cores)
      text += fmt::format("core {} against the paper's model: {}\n", core.label,
                          headline(core.diagnosis));
    for (const auto& experiment : run.experiments)
      text += fmt::format("{} ({}): {}\n", experiment.label, experiment.hidden,
                          headline(experiment.diagnosis));
    text += joint_text(run.cores, run.joint);
    text +=
        fmt::format("\n{}\n\nreport: {}\n", headline(run.cores), (out / "report.html").string());
    print_text(text);
  }
  return ExitCode::done;
}

}  // namespace

Action declare_study(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Study file")->required();
  command.footer([] {
    return "Without --out the results go to results/NAME of FILE's name.\n\nKeys of FILE "
           "(TOML):\n" +
           help_text<StudyFile>() + "\n" + exit_code_help();
  });
  return [file](const Session& session) { return run_study(session, *file); };
}

}  // namespace rebound
