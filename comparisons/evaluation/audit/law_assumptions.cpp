#include "comparisons/evaluation/audit/law_assumptions.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/integration/simulate.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Shots = std::vector<MeasuredImpact>;

/// Observables of one model at every speed against those of another.
std::vector<AuditError> errors_of(const LumpedModel& with, const LumpedModel& without,
                                  const Shots& shots) {
  std::vector<AuditError> errors;
  for (const auto& shot : shots) {
    const auto run = [&](const LumpedModel& model) {
      return simulate_fast(
                 {.sphere = shot.sphere, .impact = shot.impact, .model = model, .controls = {}})
          .scalars;
    };
    const auto a = run(with), b = run(without);
    errors.push_back({.speed = shot.impact.speed,
                      .restitution = a.restitution - b.restitution,
                      .contact_time = a.contact_time / b.contact_time - 1.0,
                      .peak_force = a.peak_force / b.peak_force - 1.0,
                      .peak_deflection = a.peak_deflection / b.peak_deflection - 1.0});
  }
  return errors;
}

LawCalibrationOptions every_trace_counts() {
  LawCalibrationOptions options;
  options.weighting = Weighting::of_peak;
  return options;
}

LumpedModel fit(const LawRequest& request, const Shots& shots, const RunControl& control) {
  return calibrate(request, shots, every_trace_counts(), control).model;
}

AuditRow damping_power(const Shots& shots, const RunControl& control) {
  const LumpedModel assumed = fit({.law = "hunt-crossley"}, shots, control);
  const LumpedModel free =
      fit({.law = "power-law", .fixed = {{"stiffness_exponent", 0.5}}}, shots, control);
  return {.id = "damping-power",
          .assumption = "damping grows with the deflection as the elastic force does, x^1.5",
          .assumed = 1.5,
          .found = free.parameters.at("damping_exponent"),
          .number = "power of the deflection in the damping that FE asks for",
          .errors = errors_of(assumed, free, shots)};
}

AuditRow one_stiffness(const Shots& shots, const RunControl& control) {
  const LumpedModel one = fit({.law = "hunt-crossley", .per_speed = {"damping"}}, shots, control);
  const LumpedModel each =
      fit({.law = "hunt-crossley", .per_speed = {"stiffness", "damping"}}, shots, control);
  double least = 1e300, most = 0.0;
  for (const auto& entry : each.at_speed) {
    least = std::min(least, entry.parameters.at("stiffness"));
    most = std::max(most, entry.parameters.at("stiffness"));
  }
  return {.id = "one-stiffness",
          .assumption = "one stiffness serves all speeds",
          .assumed = 1.0,
          .found = most / least,
          .number = "largest over smallest stiffness when each speed has its own",
          .errors = errors_of(one, each, shots)};
}

AuditRow damping_formula(const Shots& shots, const RunControl& control) {
  const LumpedModel formula =
      fit({.law = "hunt-crossley", .damping_formula = "hunt-crossley"}, shots, control);
  const LumpedModel exact =
      fit({.law = "hunt-crossley", .damping_formula = "exact"}, shots, control);
  AuditRow row{.id = "damping-formula",
               .assumption = "damping follows from restitution by Eq. (8)",
               .assumed = 0.0,
               .found = 0.0,
               .number = "largest restitution returned beyond the one that was put in",
               .errors = errors_of(formula, exact, shots)};
  for (const auto& error : row.errors) row.found = std::max(row.found, *error.restitution);
  return row;
}

AuditRow force_ends(const Shots& shots, const RunControl& control) {
  const LumpedModel linear = fit({.law = "linear-kelvin-voigt"}, shots, control);
  const LumpedModel smooth = fit({.law = "hunt-crossley"}, shots, control);
  const auto& last = shots.back();
  const double jump = linear.parameters.at("damping") * last.impact.speed;
  return {
      .id = "force-ends",
      .assumption = "a spring and dashpot may start with a force at first touch and end pulling",
      .assumed = 0.0,
      .found = jump / last.scalars.peak_force,
      .number = "force at first touch over the peak force, fastest impact; FE has none",
      .errors = errors_of(linear, smooth, shots)};
}

/// Hunt–Crossley frozen at `share` times the mean deflection of each shot.
LumpedModel frozen_at(const LumpedModel& law, const Shots& shots, double share) {
  Shots scaled = shots;
  for (auto& shot : scaled) shot.scalars.mean_deflection *= share;
  return linearise_at_mean_deflection(law, scaled);
}

double time_misfit(const LumpedModel& model, const LumpedModel& law, const Shots& shots) {
  double sum = 0.0;
  for (const auto& e : errors_of(model, law, shots))
    sum += *e.contact_time * *e.contact_time + *e.restitution * *e.restitution +
           *e.peak_force * *e.peak_force;
  return sum;
}

AuditRow mean_deflection(const Shots& shots, const RunControl& control) {
  const LumpedModel law = fit({.law = "hunt-crossley", .damping_formula = "exact"}, shots, control);
  double best = 1.0, least = 1e300;
  for (double share = 0.5; share <= 2.5; share += 0.005) {
    const double misfit = time_misfit(frozen_at(law, shots, share), law, shots);
    if (misfit < least) least = misfit, best = share;
  }
  return {.id = "mean-deflection",
          .assumption = "the mean deflection is the one to linearise Hunt-Crossley at",
          .assumed = 1.0,
          .found = best,
          .number = "deflection that serves best, over the mean one",
          .errors = errors_of(frozen_at(law, shots, 1.0), frozen_at(law, shots, best), shots)};
}

AuditRow exponent(const Shots& shots, const RunControl& control) {
  const LumpedModel assumed = fit({.law = "hunt-crossley"}, shots, control);
  const LumpedModel free = fit({.law = "hunt-crossley", .free = {"exponent"}}, shots, control);
  return {.id = "exponent",
          .assumption = "the force goes with the deflection to the power 1.5",
          .assumed = 1.5,
          .found = free.parameters.at("exponent"),
          .number = "exponent that FE asks for",
          .errors = errors_of(assumed, free, shots)};
}

}  // namespace

std::vector<AuditRow> audit_laws(const Shots& shots, const RunControl& control) {
  std::vector<AuditRow> rows;
  for (auto* row :
       {damping_power, one_stiffness, damping_formula, force_ends, mean_deflection, exponent}) {
    rows.push_back(row(shots, control));
    rows.back().verdict = verdict_of(rows.back().errors);
  }
  return rows;
}

}  // namespace rebound
