#include "comparisons/evaluation/audit/fem_assumptions.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

AuditError error_of(double speed, const ImpactScalars& with, const ImpactScalars& without) {
  return {.speed = speed,
          .restitution = with.restitution - without.restitution,
          .contact_time = with.contact_time / without.contact_time - 1.0,
          .peak_force = with.peak_force / without.peak_force - 1.0,
          .peak_deflection = with.peak_deflection / without.peak_deflection - 1.0};
}

std::vector<Impact> impacts_of(const AuditRequest& request) {
  std::vector<Impact> impacts;
  for (double speed : request.speeds) impacts.push_back({.speed = speed});
  return impacts;
}

void require_complete(const std::vector<FemResult>& results) {
  for (const auto& result : results)
    if (!result.incomplete_because.empty())
      throw Error(ExitCode::solver_failed, result.incomplete_because);
}

double peak_of_column(const Trace& trace, const std::string& name) {
  for (const auto& column : trace.further)
    if (column.name == name) return *std::max_element(column.values.begin(), column.values.end());
  throw Error(ExitCode::solver_failed, "the FE trace has no column " + name);
}

AuditRow centre_of_mass(const AuditRequest& request, const std::vector<FemResult>& base) {
  AuditRow row{.id = "centre-of-mass",
               .assumption = "the deflection of the centre of mass is that of the contact",
               .assumed = 1.0,
               .found = 0.0,
               .number =
                   "peak deflection of the far pole over that of the centre of mass, "
                   "fastest impact",
               .errors = {}};
  for (std::size_t i = 0; i < base.size(); ++i) {
    const double ratio =
        peak_of_column(base[i].trace, "pole_deflection_m") / base[i].scalars.peak_deflection;
    row.found = ratio;
    row.errors.push_back({.speed = request.speeds[i], .peak_deflection = 1.0 / ratio - 1.0});
  }
  return row;
}

/// The same ball without branches: what it loses goes into vibration, and what
/// differs from a slowly squeezed sphere is inertia and finite strain.
AuditRow quasi_static(const AuditRequest& request, const FemRunner& run) {
  AuditRow row{.id = "quasi-static",
               .assumption = "the ball deforms as if it were squeezed slowly",
               .assumed = 0.0,
               .found = 0.0,
               .number = "energy left in vibration after an elastic impact, share, fastest impact",
               .errors = {}};
  AuditRequest elastic = request;
  elastic.problem.material.branches.clear();
  const auto results = run_impacts(elastic.problem, impacts_of(request), run);
  require_complete(results);
  const auto& material = elastic.problem.material;
  const double nu = material.poisson_ratio;
  const double stiffness = 4.0 / 3.0 * material.youngs_modulus / (1.0 - nu * nu) *
                           std::sqrt(request.problem.sphere.radius());
  for (std::size_t i = 0; i < results.size(); ++i) {
    LumpedModel slow;
    slow.law = "finite-sphere-hertz";
    slow.parameters = {{"stiffness", stiffness}, {"dissipation_time", 0.0}, {"poisson_ratio", nu}};
    const auto s = simulate_fast({.sphere = request.problem.sphere,
                                  .impact = {.speed = request.speeds[i]},
                                  .model = slow,
                                  .controls = {}})
                       .scalars;
    row.errors.push_back(error_of(request.speeds[i], s, results[i].scalars));
    row.found = results[i].vibrational_energy_share;
  }
  return row;
}

/// FE with another plate against FE with the rigid one.
AuditRow other_plate(AuditRow row, const AuditRequest& request, const Plate& plate,
                     const std::vector<FemResult>& base, const FemRunner& run) {
  AuditRequest other = request;
  other.problem.plate = plate;
  try {
    const auto results = run_impacts(other.problem, impacts_of(request), run);
    require_complete(results);
    for (std::size_t i = 0; i < base.size(); ++i)
      row.errors.push_back(error_of(request.speeds[i], base[i].scalars, results[i].scalars));
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    row.errors.clear();
    row.verdict = AuditVerdict::not_run;
    row.sentence = std::string("not run: ") + error.what();
  }
  return row;
}

}  // namespace

std::vector<AuditRow> audit_bodies(const AuditRequest& request, const std::vector<FemResult>& base,
                                   const FemRunner& run) {
  std::vector<AuditRow> rows = {centre_of_mass(request, base), quasi_static(request, run)};
  Plate soft;
  soft.stiffness = request.plate_stiffness;
  const double contact = base.back().scalars.peak_force / base.back().scalars.peak_deflection;
  rows.push_back(
      other_plate({.id = "rigid-plate",
                   .assumption = "the plate does not give way, and its load cell reads the contact "
                                 "force",
                   .assumed = 0.0,
                   .found = contact / request.plate_stiffness,
                   .number = "stiffness of the ball over that of the plate, fastest impact",
                   .errors = {}},
                  request, soft, base, run));
  Plate rough;
  rough.friction = 0.3;
  rows.push_back(other_plate({.id = "friction",
                              .assumption = "the plate does not rub",
                              .assumed = 0.0,
                              .found = rough.friction,
                              .number = "friction coefficient it is tried with",
                              .errors = {}},
                             request, rough, base, run));
  for (auto& row : rows)
    if (!row.errors.empty()) row.verdict = verdict_of(row.errors);
  return rows;
}

}  // namespace rebound
