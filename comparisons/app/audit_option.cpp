#include "comparisons/app/audit_option.hpp"

#include <fmt/format.h>

#include "comparisons/app/progress_line.hpp"
#include "comparisons/audit/audit_text.hpp"
#include "comparisons/config/impact_file.hpp"
#include "comparisons/modules/fem_runner.hpp"
#include "comparisons/results/atomic_file.hpp"

namespace rebound {

ExitCode run_audit_option(const Session& session, const std::string& path,
                          const std::vector<double>& speeds) {
  const Document document = Document::load(path);
  const AuditRequest request{.problem = read_fem_problem(document), .speeds = speeds};
  if (!request.problem.mesh_file.empty())
    throw document.error_at("model.mesh", "the audit makes its own mesh", "cells instead of mesh");
  if (!session.out.empty()) make_writable_folder(session.out);
  ProgressLine progress("audit");
  const RunControl control = progress.control();
  const FemRunner run = fem_runner(request.problem.sphere, request.problem.cells, control);
  const Audit audit = run_audit(request, run, control);
  const Json json = to_json(audit);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "audit.json", dump(stored));
  }
  fmt::print("{}", session.json() ? dump(json) : to_text(audit));
  return ExitCode::done;
}

}  // namespace rebound
