#include "comparisons/inference/references/law_score.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/integration/force_deflection.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr int comparison_points =
    801;  // of force over time; both traces are smooth at that spacing
constexpr LumpedControls model_controls{.relative_tolerance = 1e-9, .samples = 801};

std::optional<double> relative(double model, std::optional<double> reference) {
  if (!reference || !(*reference > 0.0)) return std::nullopt;
  return model / *reference - 1.0;
}

ScalarErrors compare(const ImpactScalars& model, const ImpactScalars& reference) {
  return {.peak_force = relative(model.peak_force, reference.peak_force),
          .peak_deflection = relative(model.peak_deflection, reference.peak_deflection),
          .mean_deflection = relative(model.mean_deflection, reference.mean_deflection),
          .contact_time = relative(model.contact_time, reference.contact_time),
          .contact_time_1pct = relative(model.contact_time_1pct, reference.contact_time_1pct),
          .restitution = relative(model.restitution, reference.restitution)};
}

ScalarErrors compare(const ImpactScalars& model, const MeasuredImpact& measured) {
  return {.peak_force = relative(model.peak_force, measured.peak_force.value),
          .peak_deflection = relative(model.peak_deflection, measured.peak_deflection.value),
          .mean_deflection = relative(model.mean_deflection, measured.mean_deflection.value),
          .contact_time = relative(model.contact_time, measured.contact_time.value),
          .contact_time_1pct = std::nullopt,
          .restitution = relative(model.restitution, measured.restitution.value)};
}

/// Force at an instant, linear between samples, zero after the last one.
double force_at(const Trace& trace, double instant) {
  const auto above = std::upper_bound(trace.time.begin(), trace.time.end(), instant);
  if (above == trace.time.begin()) return trace.force.front();
  if (above == trace.time.end()) return instant > trace.time.back() ? 0.0 : trace.force.back();
  const auto i = static_cast<std::size_t>(above - trace.time.begin());
  const double fraction = (instant - trace.time[i - 1]) / (trace.time[i] - trace.time[i - 1]);
  return trace.force[i - 1] + fraction * (trace.force[i] - trace.force[i - 1]);
}

double force_time_rms(const Trace& model, const Trace& reference) {
  const double duration = std::max(model.time.back(), reference.time.back());
  double sum = 0.0;
  for (int i = 0; i < comparison_points; ++i) {
    const double instant = duration * i / (comparison_points - 1);
    sum += std::pow(force_at(model, instant) - force_at(reference, instant), 2);
  }
  return std::sqrt(sum / comparison_points);
}

double force_deflection_rms(const LumpedProblem& problem, const Trace& reference) {
  const std::vector<double> model = forces_at(problem, deflection_points(reference));
  double sum = 0.0;
  for (std::size_t i = 0; i < model.size(); ++i) sum += std::pow(model[i] - reference.force[i], 2);
  return std::sqrt(sum / static_cast<double>(model.size()));
}

}  // namespace

void check_scorable(const MeasuredImpact& reference) {
  const Trace& trace = reference.trace;
  if (trace.time.size() < 5 || trace.force.size() != trace.time.size() ||
      trace.deflection.size() != trace.time.size() ||
      !(*std::max_element(trace.force.begin(), trace.force.end()) > 0.0))
    throw Error(ExitCode::bad_input, "reference '" + reference.label +
                                         "' needs force and deflection at five instants or more");
}

LawScore score_law(const LumpedModel& model, const MeasuredImpact& reference) {
  const LumpedProblem problem{.sphere = reference.sphere,
                              .impact = reference.impact,
                              .model = model,
                              .controls = model_controls};
  LawScore cell;
  try {
    const LumpedResult run = simulate_fast(problem);
    const auto& trace = reference.trace;
    const double peak = *std::max_element(trace.force.begin(), trace.force.end());
    cell.scalars = run.scalars;
    cell.against_reference = compare(run.scalars, reference.scalars);
    cell.against_measured = compare(run.scalars, reference);
    cell.force_time_rms = force_time_rms(run.trace, trace) / peak;
    cell.force_deflection_rms = force_deflection_rms(problem, trace) / peak;
  } catch (const Error& error) {
    cell.failure = error.what();
  }
  return cell;
}

}  // namespace rebound
