#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

#include "comparisons/accuracy/foams/foam_rows.hpp"
#include "comparisons/accuracy/verification/coverage_case.hpp"
#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/expected_rows.hpp"
#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/lumped_cases.hpp"
#include "comparisons/accuracy/verification/memory_growth.hpp"
#include "comparisons/accuracy/verification/mesh_comparison.hpp"
#include "comparisons/accuracy/verification/mesh_family.hpp"
#include "comparisons/accuracy/verification/seeded_faults.hpp"
#include "comparisons/accuracy/verification/ting_case.hpp"
#include "comparisons/accuracy/verification/verification_report.hpp"
#include "comparisons/accuracy/verification/verification_text.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/models/fem_access/element_checks.hpp"
#include "comparisons/models/fem_access/material_laws.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/installation.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

using Control = const RunControl&;

std::vector<SuitePart> lumped_parts() {
  return {{"Lumped laws (f, h)", 0.1, [](Control) { return VerificationPart{verify_lumped()}; }},
          {"Viscoelastic contact (e, lumped)", 0.5,
           [](Control) { return VerificationPart{verify_viscoelastic_contact()}; }},
          {"Error estimator", 0.1, [](Control) { return VerificationPart{verify_estimator()}; }}};
}

std::vector<SuitePart> fem_parts(const FemTier& tier, const GmshModule& gmsh,
                                 const ElementChecks& checks) {
  return {
      {"Manufactured solution (a)", 0.3, [&](Control) { return verify_fields(checks); }},
      {"Order in time (a)", 0.3, [&](Control c) { return verify_time_order(tier, c); }},
      {"Free vibration (b)", 0.9, [&](Control) { return verify_free_vibration(checks); }},
      {"Nearly incompressible", 3.0, [&](Control) { return verify_nearly_incompressible(checks); }},
      {"Linear contact (c)", 0.4, [&](Control) { return verify_linear_contact(checks); }},
      {"Static contact (c)", 1.0, [&](Control c) { return verify_static_contact(tier, c); }},
      {"Elastic impact of the sphere (d)", 3.0,
       [&](Control c) { return verify_sphere_impacts(tier, c); }},
      {"Bar (d')", 0.5, [&](Control c) { return verify_bar(tier, c); }},
      {"Standard linear solid along a triangle (e)", 4.5,
       [&](Control c) { return verify_ting(tier, CompressionPath::triangle, c); }},
      {"Standard linear solid along a half sine (e)", 4.5,
       [&](Control c) { return verify_ting(tier, CompressionPath::half_sine, c); }},
      {"Viscoelastic cells (g)", 0.6, [&](Control) { return verify_viscoelastic_cells(checks); }},
      {"Both schemes", 3.0, [&](Control c) { return verify_schemes(tier, c); }},
      {"Free plate", 0.5, [&](Control c) { return verify_free_plate(tier, c); }},
      {"Every channel", 0.5, [&](Control c) { return verify_all_channels(tier, c); }},
      {"Coverage of error bars", 0.1, [](Control) { return verify_coverage(coverage_file()); }},
      {"Error bars", 1.0, [&](Control c) { return verify_error_bars(tier, c); }},
      {"Unstructured cells", 1.5, [&](Control c) { return verify_unstructured(tier, gmsh, c); }},
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

void append(SuiteOutcome& outcome, SuiteOutcome more) {
  for (auto& one : more.complete) outcome.complete.push_back(std::move(one));
  for (auto& name : more.not_run) outcome.not_run.push_back(std::move(name));
}

SuiteOutcome verify(const std::string& tier) {
  SuiteOutcome found;
  if (tier != "fem") append(found, run_suite(lumped_parts(), {}));
  if (tier == "lumped") return found;
  if (tier == "all" && !has_fem_tier()) {
    fmt::print(stderr, "rebound: built without the FE tier; its cases are left out\n");
    return found;
  }
  const FemTier& fem = fem_tier();
  material_laws();  // loaded before there are threads
  ProgressLine progress("FE cases");
  append(found, run_suite(fem_parts(fem, gmsh_module(), element_checks()), progress.control()));
  // Each by itself: what these measure depends on what else runs.
  for (const SuitePart& part :
       {SuitePart{"Finite elements under refinement", 4.0,
                  [&](Control c) { return verify_refinement(fem, c); }},
        SuitePart{"Memory over the cells", 4.0, [&](Control c) { return verify_memory(fem, c); }}})
    append(found, run_suite({part}, progress.control()));
  return found;
}

void write_all(const Session& session, const SuiteOutcome& suite, Json stored, bool foams) {
  stored["provenance"] = to_json(provenance_of(session, "", ""));
  write_file_atomically(session.out / "verify.json", dump(stored));
  write_file_atomically(session.out / "verify.csv", to_csv(suite.rows()));
  report::write_report(verification_report(suite), session.out / "report.html");
  if (foams) write_foam_curves(material_laws(), published_foams(), session.out);
}

/// The row that fails where one is missing that the list expects; said to which it fell.
VerificationPart missing_rows_part(const SuiteOutcome& suite, const std::string& tier) {
  using Tier = ExpectedRow::Tier;
  std::vector<Tier> tiers;
  if (tier != "fem") tiers.push_back(Tier::lumped);
  if (tier != "lumped" && has_fem_tier()) tiers.push_back(Tier::fem);
  if (tier == "all") tiers.push_back(Tier::faults);
  const auto missing = missing_rows(suite.rows(), tiers);
  for (const std::string& row : missing)
    fmt::print(stderr, "rebound: an expected row is missing: {}\n", row);
  return {.rows = {row_of_missing(missing)}};
}

ExitCode run_verify(const Session& session, const std::string& tier) {
  if (!session.out.empty()) make_writable_folder(session.out);
  const std::vector<SeededFault> faults =
      tier == "all" ? read_seeded_faults(seeded_faults_folder(), source_folder())
                    : std::vector<SeededFault>{};
  SuiteOutcome suite = verify(tier);
  if (tier == "all") suite.complete.push_back({"Seeded faults", seeded_faults_part(faults)});
  if (suite.not_run.empty())
    suite.complete.push_back({"Rows of the suite", missing_rows_part(suite, tier)});
  const VerificationTable table = suite.rows();
  Json json = to_json(table);
  json["not_run"] = suite.not_run;
  json["seeded_faults"] = to_json(faults);
  if (!session.out.empty()) write_all(session, suite, json, tier != "lumped" && has_fem_tier());
  if (tier == "all" && !session.json()) print_text(to_text(faults));
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(table));
  if (!suite.not_run.empty()) {
    fmt::print(stderr, "rebound: interrupted; {} rows are complete; not run: {}\n", table.size(),
               fmt::join(suite.not_run, ", "));
    return ExitCode::interrupted;
  }
  return all_pass(table) ? ExitCode::done : ExitCode::comparison_failed;
}

}  // namespace

Action declare_verify(CLI::App& command) {
  const auto tier = std::make_shared<std::string>("all");
  command.add_option("--tier", *tier, "Which cases: lumped (milliseconds), fem, or all")
      ->check(CLI::IsMember({"lumped", "fem", "all"}))
      ->capture_default_str();
  command.footer([] {
    return "Exit code 1 where a row fails. Ctrl-C prints the rows that are complete and names the "
           "parts "
           "that were not run. --out writes verify.json, verify.csv, report.html with convergence "
           "plots "
           "and, with the FE tier, the curves of published foams (foams.csv, foams.html).\n\n" +
           exit_code_help();
  });
  return [tier](const Session& session) { return run_verify(session, *tier); };
}

}  // namespace rebound
