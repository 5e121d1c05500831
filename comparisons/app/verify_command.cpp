#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/foams/foam_rows.hpp"
#include "comparisons/modules/element_checks.hpp"
#include "comparisons/modules/material_laws.hpp"
#include "comparisons/modules/module_loader.hpp"
#include "comparisons/report/write_report.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/verification/element_rungs.hpp"
#include "comparisons/verification/fem_rungs.hpp"
#include "comparisons/verification/lumped_rungs.hpp"
#include "comparisons/verification/memory_growth.hpp"
#include "comparisons/verification/mesh_family.hpp"
#include "comparisons/verification/seeded_faults.hpp"
#include "comparisons/verification/ting_rung.hpp"
#include "comparisons/verification/verification_report.hpp"
#include "comparisons/verification/verification_text.hpp"

namespace rebound {
namespace {

using Control = const RunControl&;

std::vector<LadderPart> lumped_parts() {
  return {{"Lumped laws (f, h)", 0.1, [](Control) { return VerificationPart{verify_lumped()}; }},
          {"Viscoelastic contact (e, lumped)", 0.5,
           [](Control) { return VerificationPart{verify_viscoelastic_contact()}; }},
          {"Error estimator", 0.1, [](Control) { return VerificationPart{verify_estimator()}; }}};
}

std::vector<LadderPart> fem_parts(const FemTier& tier, const ElementChecks& checks) {
  return {
      {"Manufactured solution (a)", 0.3, [&](Control) { return verify_fields(checks); }},
      {"Order in time (a)", 0.3, [&](Control c) { return verify_time_order(tier, c); }},
      {"Free vibration (b)", 0.9, [&](Control) { return verify_free_vibration(checks); }},
      {"Linear contact (c)", 0.4, [&](Control) { return verify_linear_contact(checks); }},
      {"Static contact (c)", 1.0, [&](Control c) { return verify_static_contact(tier, c); }},
      {"Elastic impact of the sphere (d)", 3.0, [&](Control c) { return verify_sphere_impacts(tier, c); }},
      {"Bar (d')", 0.5, [&](Control c) { return verify_bar(tier, c); }},
      {"Standard linear solid along a triangle (e)", 4.5,
       [&](Control c) { return verify_ting(tier, CompressionPath::triangle, c); }},
      {"Standard linear solid along a half sine (e)", 4.5,
       [&](Control c) { return verify_ting(tier, CompressionPath::half_sine, c); }},
      {"Viscoelastic cells (g)", 0.6, [&](Control) { return verify_viscoelastic_cells(checks); }},
      {"Both schemes", 3.0, [&](Control c) { return verify_schemes(tier, c); }},
      {"Free plate", 0.5, [&](Control c) { return verify_free_plate(tier, c); }},
      {"Every channel", 0.5, [&](Control c) { return verify_all_channels(tier, c); }},
      {"Error bars", 1.0, [&](Control c) { return verify_error_bars(tier, c); }},
      {"Closed cycles", 1.0, [&](Control) { return verify_dissipation(checks); }},
      {"Published contact", 1.0, [&](Control c) { return verify_published_contact(tier, c); }},
      {"Published rod", 0.3, [&](Control) { return verify_published_rod(checks); }},
      {"Published foams", 0.1,
       [](Control) { return VerificationPart{verify_foams(material_laws(), published_foams())}; }}};
}

VerificationPart verify_refinement(const FemTier& tier, Control control) {
  const auto family = run_mesh_family(tier, control);
  return {.rows = rows_of(family), .figures = figures_of(family)};
}

VerificationPart seeded_faults_part(const std::vector<SeededFault>& faults) {
  VerificationPart part{.rows = rows_of(faults)};
  if (!faults.empty()) part.tables = {table_of(faults)};
  return part;
}

void append(LadderOutcome& outcome, LadderOutcome more) {
  for (auto& one : more.complete) outcome.complete.push_back(std::move(one));
  for (auto& name : more.not_run) outcome.not_run.push_back(std::move(name));
}

LadderOutcome verify(const std::string& tier) {
  LadderOutcome found;
  if (tier != "fem") append(found, run_ladder(lumped_parts(), {}));
  if (tier == "lumped") return found;
  if (tier == "all" && !has_fem_tier()) {
    fmt::print(stderr, "rebound: built without the FE tier; its rungs are left out\n");
    return found;
  }
  const FemTier& fem = fem_tier();
  material_laws();  // loaded before there are threads
  ProgressLine progress("FE rungs");
  append(found, run_ladder(fem_parts(fem, element_checks()), progress.control()));
  // Each by itself: what these measure depends on what else runs.
  for (const LadderPart& part :
       {LadderPart{"Finite elements under refinement", 4.0, [&](Control c) { return verify_refinement(fem, c); }},
        LadderPart{"Memory over the cells", 4.0, [&](Control c) { return verify_memory(fem, c); }}})
    append(found, run_ladder({part}, progress.control()));
  return found;
}

void write_all(const Session& session, const LadderOutcome& ladder, Json stored, bool foams) {
  stored["provenance"] = to_json(provenance_of(session, "", ""));
  write_file_atomically(session.out / "verify.json", dump(stored));
  write_file_atomically(session.out / "verify.csv", to_csv(ladder.rows()));
  report::write_report(verification_report(ladder), session.out / "report.html");
  if (foams) write_foam_curves(material_laws(), published_foams(), session.out);
}

ExitCode run_verify(const Session& session, const std::string& tier) {
  if (!session.out.empty()) make_writable_folder(session.out);
  const std::vector<SeededFault> faults =
      tier == "all" ? read_seeded_faults(seeded_faults_folder()) : std::vector<SeededFault>{};
  LadderOutcome ladder = verify(tier);
  if (tier == "all") ladder.complete.push_back({"Seeded faults", seeded_faults_part(faults)});
  const VerificationTable table = ladder.rows();
  Json json = to_json(table);
  json["not_run"] = ladder.not_run;
  json["seeded_faults"] = to_json(faults);
  if (!session.out.empty()) write_all(session, ladder, json, tier != "lumped" && has_fem_tier());
  if (tier == "all" && !session.json()) fmt::print("{}", to_text(faults));
  fmt::print("{}", session.json() ? dump(json) : to_text(table));
  if (!ladder.not_run.empty()) {
    fmt::print(stderr, "rebound: interrupted; {} rows are complete; not run: {}\n", table.size(),
               fmt::join(ladder.not_run, ", "));
    return ExitCode::interrupted;
  }
  return all_pass(table) ? ExitCode::done : ExitCode::comparison_failed;
}

}  // namespace

Action declare_verify(CLI::App& command) {
  const auto tier = std::make_shared<std::string>("all");
  command.add_option("--tier", *tier, "Which rungs: lumped (milliseconds), fem, or all")
      ->check(CLI::IsMember({"lumped", "fem", "all"}))
      ->capture_default_str();
  command.footer([] {
    return "Exit code 1 where a row fails. Ctrl-C prints the rows that are complete and names the parts "
           "that were not run. --out writes verify.json, verify.csv, report.html with convergence plots "
           "and, with the FE tier, the curves of published foams (foams.csv, foams.html).\n\n" +
           exit_code_help();
  });
  return [tier](const Session& session) { return run_verify(session, *tier); };
}

}  // namespace rebound
