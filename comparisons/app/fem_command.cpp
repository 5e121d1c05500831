#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "comparisons/accuracy/numerical_error/error_bars.hpp"
#include "comparisons/accuracy/numerical_error/reference_json.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/io/impact_report/impact_report.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/results/result_folder.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/material_stability.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string fem_help() {
  return "--out DIR writes result.json, trace.csv, effective.toml and report.html; with "
         "field_frames also "
         "fields/impact.pvd for ParaView and the moving half-section of the report.\n\n"
         "Keys of FILE (TOML):\n" +
         help_text<FemImpactFile>() + "\n" + exit_code_help();
}

constexpr const char* report_name = "report.html";

/// Frames of an earlier run must not stand beside a result without any.
void remove_earlier_frames(const std::filesystem::path& fields) {
  std::error_code status;
  std::filesystem::remove(fields / "impact.pvd", status);
  std::vector<std::filesystem::path> frames;
  for (const auto& entry : std::filesystem::directory_iterator(fields, status)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame-") && name.ends_with(".vtu")) frames.push_back(entry.path());
  }
  for (const auto& frame : frames) std::filesystem::remove(frame, status);
}

void prepare_output(const Session& session, const Document& document, FemProblem& problem) {
  if (!session.out.empty()) {
    make_writable_folder(session.out);
    std::error_code status;  // the page of an earlier run must not stand beside this one
    std::filesystem::remove(session.out / report_name, status);
    remove_earlier_frames(session.out / "fields");
  }
  if (problem.controls.field_frames == 0) return;
  if (session.out.empty())
    throw document.error_at("controls.field_frames", "fields need a folder to go to: give --out");
  const auto fields = session.out / "fields";
  make_writable_folder(fields);
  problem.controls.field_directory = fields.string();
}

enum class Errors { not_asked, reference };

struct Outcome {
  FemResult result;
  Json json;  ///< null when incomplete
  std::optional<report::Section> error_bars{};
};

Outcome simulate(FemProblem problem, Errors errors) {
  ProgressLine progress("FE impact");
  constexpr int finest = 16, family = 1 + 4 + finest;
  const Mesh mesh = mesh_for(problem, progress.control(), errors == Errors::reference ? family : 1);
  const bool quarters =
      problem.scheme == FemScheme::implicit_steps;  // as a nine-node cell is drawn
  const int cells = static_cast<int>(mesh.cells.size()) *
                    (errors == Errors::reference ? finest : 1) * (quarters ? 4 : 1);
  problem.controls.shape_frames = animated_frames(problem.controls.field_frames, cells);
  if (errors == Errors::reference) {
    ReferenceImpact reference = run_reference(fem_tier(), problem, mesh, progress.control());
    Json json = to_json(reference);
    report::Section bars = error_bars(reference);
    return {std::move(reference.result), std::move(json), std::move(bars)};
  }
  FemResult result = watched_impact(problem, mesh, progress.control());
  for (const std::string& warning : result.warnings) fmt::print(stderr, "rebound: {}\n", warning);
  Json json = result.incomplete_because.empty() ? to_json(result) : Json();
  return {std::move(result), std::move(json)};
}

ExitCode run_fem(const Session& session, const std::string& file, Errors errors) {
  const Document document = Document::load(file);
  const FemImpactFile impact_file = read_fem_impact(document);
  FemProblem problem =
      applied({.problem = impact_file.problem, .effects = without_measurement(impact_file.effects)},
              document);
  prepare_output(session, document, problem);
  Outcome outcome;
  try {
    outcome = simulate(problem, errors);
  } catch (const Error& error) {
    throw document.located(error);
  }
  if (!session.out.empty()) {
    write_result({.folder = session.out,
                  .effective_toml = write_toml(impact_file),
                  .provenance = provenance_with_fem(session, file, document.text()),
                  .further_keys = outcome.json},
                 outcome.result);
    if (outcome.result.incomplete_because.empty()) {
      report::Report page = impact_report(problem, outcome.result);
      if (outcome.error_bars)
        page.sections.insert(page.sections.begin() + 1, std::move(*outcome.error_bars));
      report::write_report(page, session.out / report_name);
    }
  }
  require_complete(session, file, outcome.result.incomplete_because);
  print_result(session, outcome.json);
  return ExitCode::done;
}

}  // namespace

Action declare_fem(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Impact file with [model] tier = \"fem\"")->required();
  const auto reference = std::make_shared<bool>(false);
  command.add_flag(
      "--reference", *reference,
      "Give every scalar and the trace a numerical error bar: three meshes, from the "
      "cells asked for (or the mesh file) to 16 times as many, half the step, speeds "
      "nearby. The finest mesh is the result; whether the material is unstable is not looked "
      "for");
  command.footer(fem_help);
  return [file, reference](const Session& session) {
    return run_fem(session, *file, *reference ? Errors::reference : Errors::not_asked);
  };
}

}  // namespace rebound
