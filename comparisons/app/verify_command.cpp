#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/foams/foam_rows.hpp"
#include "comparisons/modules/material_laws.hpp"
#include "comparisons/modules/module_loader.hpp"
#include "comparisons/report/write_report.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/verification/fem_rungs.hpp"
#include "comparisons/verification/lumped_rungs.hpp"
#include "comparisons/verification/mesh_family.hpp"
#include "comparisons/verification/second_scheme_rungs.hpp"
#include "comparisons/verification/verification_report.hpp"
#include "comparisons/verification/verification_text.hpp"

namespace rebound {
namespace {

void append(VerificationTable& table, VerificationTable rows) {
  for (VerificationRow& row : rows) table.push_back(std::move(row));
}

struct Verification {
  VerificationTable table;
  std::vector<FamilyImpact> family;  ///< empty without the FE tier
};

Verification verify(const std::string& tier) {
  Verification found;
  VerificationTable& table = found.table;
  if (tier != "fem") {
    append(table, verify_lumped());
    append(table, verify_estimator());
  }
  if (tier == "lumped") return found;
  if (tier == "all" && !has_fem_tier()) {
    fmt::print(stderr, "rebound: built without the FE tier; its rungs are left out\n");
    return found;
  }
  ProgressLine progress("FE rungs");
  append(table, verify_foams(material_laws(), published_foams()));
  append(table, verify_fem(fem_tier(), progress.control()));
  append(table, verify_second_scheme(fem_tier(), progress.control()));
  found.family = run_mesh_family(fem_tier(), progress.control());
  append(table, rows_of(found.family));
  return found;
}

ExitCode run_verify(const Session& session, const std::string& tier) {
  if (!session.out.empty()) make_writable_folder(session.out);
  const auto [table, family] = verify(tier);
  const Json json = to_json(table);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, "", ""));
    write_file_atomically(session.out / "verify.json", dump(stored));
    report::write_report(verification_report(table, family), session.out / "report.html");
    if (tier != "lumped" && has_fem_tier())
      write_foam_curves(material_laws(), published_foams(), session.out);
  }
  fmt::print("{}", session.json() ? dump(json) : to_text(table));
  return all_pass(table) ? ExitCode::done : ExitCode::comparison_failed;
}

}  // namespace

Action declare_verify(CLI::App& command) {
  const auto tier = std::make_shared<std::string>("all");
  command.add_option("--tier", *tier, "Which rungs: lumped (milliseconds), fem, or all")
      ->check(CLI::IsMember({"lumped", "fem", "all"}))
      ->capture_default_str();
  command.footer([] {
    return "Exit code 1 where a row fails. --out writes verify.json, report.html and, with the FE "
           "tier, the curves of published foams (foams.csv, foams.html).\n\n" + exit_code_help();
  });
  return [tier](const Session& session) { return run_verify(session, *tier); };
}

}  // namespace rebound
