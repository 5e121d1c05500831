#include "comparisons/evaluation/audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/evaluation/audit/fem_assumptions.hpp"
#include "comparisons/evaluation/audit/law_assumptions.hpp"
#include "comparisons/inference/references/contact_alone.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double moves = 0.02;
constexpr double breaks = 0.10;

double largest(const AuditError& error) {
  double size = 0.0;
  for (const auto& value :
       {error.restitution, error.contact_time, error.peak_force, error.peak_deflection})
    if (value) size = std::max(size, std::abs(*value));
  return size;
}

std::string sentence_of(const AuditRow& row) {
  double size = 0.0, speed = 0.0;
  for (const auto& error : row.errors)
    if (largest(error) >= size) {
      size = largest(error);
      speed = error.speed;
    }
  const char* word = row.verdict == AuditVerdict::holds     ? "holds"
                     : row.verdict == AuditVerdict::matters ? "matters"
                                                            : "fails";
  return fmt::format("{}: moves an observable by {:.3g} % at most, at {:g} m/s", word, 100.0 * size,
                     speed);
}

}  // namespace

AuditVerdict verdict_of(const std::vector<AuditError>& errors) {
  double size = 0.0;
  for (const auto& error : errors) size = std::max(size, largest(error));
  return size < moves    ? AuditVerdict::holds
         : size < breaks ? AuditVerdict::matters
                         : AuditVerdict::fails;
}

Audit run_audit(const AuditRequest& request, const FemRunner& run, const RunControl& control) {
  if (request.speeds.size() < 2 || !std::is_sorted(request.speeds.begin(), request.speeds.end()))
    throw Error(ExitCode::bad_input, "an audit needs two speeds or more, ascending",
                {.key = "--speeds", .value = "", .allowed = "for example 5 15 25"});
  const auto step = [&](double fraction) {
    if (control.progress) control.progress(fraction);
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "the audit was interrupted before it ended");
  };
  std::vector<Impact> impacts;
  for (double speed : request.speeds) impacts.push_back({.speed = speed});
  const std::vector<FemResult> base = run_impacts(request.problem, impacts, run);
  std::vector<MeasuredImpact> shots;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (!base[i].incomplete_because.empty())
      throw Error(ExitCode::solver_failed, base[i].incomplete_because);
    shots.push_back(
        contact_alone(request.problem.sphere, impacts[i], base[i].trace, base[i].scalars));
  }
  step(0.3);
  Audit audit{.speeds = request.speeds, .rows = audit_laws(shots, control)};
  step(0.6);
  for (auto& row : audit_bodies(request, base, run)) audit.rows.push_back(std::move(row));
  for (auto& row : audit.rows)
    if (row.sentence.empty()) row.sentence = sentence_of(row);
  step(1.0);
  return audit;
}

}  // namespace rebound
