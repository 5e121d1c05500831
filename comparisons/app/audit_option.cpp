#include "comparisons/app/audit_option.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/audit/audit_text.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {

ExitCode run_audit_option(const Session& session, const std::string& path,
                          const std::vector<double>& speeds) {
  const Document document = Document::load(path);
  const AuditRequest request{.problem = read_fem_problem(document), .speeds = speeds};
  if (!session.out.empty()) make_writable_folder(session.out);
  ProgressLine progress("audit");
  const RunControl control = progress.control();
  FemProblem slowest = request.problem;
  if (!speeds.empty()) slowest.impact.speed = *std::min_element(speeds.begin(), speeds.end());
  const Mesh mesh = mesh_for(slowest, control);
  const FemRunner run = fem_runner(mesh, request.problem.sphere, control);
  const Audit audit = run_audit(request, run, control);
  Json json = to_json(audit);
  json["cells"] = mesh.cells.size();
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "audit.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(audit));
  return ExitCode::done;
}

}  // namespace rebound
