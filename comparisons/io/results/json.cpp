#include "comparisons/io/results/json.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}
/// Lines and columns begin at 1.
Json place_or_null(int number) {
  return number == 0 ? Json(nullptr) : Json(number);
}

Json shared_keys(const ImpactScalars& scalars, const Closures& closures, double wall_seconds) {
  return {{"schema", 1},
          {"restitution", scalars.restitution},
          {"contact_time_s", scalars.contact_time},
          {"contact_time_1pct_s", scalars.contact_time_1pct},
          {"peak_force_N", scalars.peak_force},
          {"peak_deflection_m", scalars.peak_deflection},
          {"mean_deflection_m", scalars.mean_deflection},
          {"rebound_speed_m_s", scalars.rebound_speed},
          {"kinetic_energy_loss_share", kinetic_energy_loss_share(scalars)},
          {"separation_rule", name_of(scalars.separation)},
          {"impulse_closure", closures.impulse},
          {"energy_closure", closures.energy},
          {"wall_s", wall_seconds}};
}

/// What the load cell under a plate reads, by the definitions of the contact force's keys.
void add_load_cell(Json& json, const Trace& trace) {
  if (&contact_force(trace) == &trace.force) return;
  const double peak = refined_peak(trace.time, trace.force);
  json["load_cell"] = {{"peak_force_N", peak},
                       {"contact_time_1pct_s", time_above(trace, 0.01 * peak)}};
}

}  // namespace

Json to_json(const LumpedResult& result) {
  Json json = shared_keys(result.scalars, result.closures, result.wall_seconds);
  add_load_cell(json, result.trace);
  return json;
}

Json to_json(const FemResult& result) {
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  Json json = shared_keys(result.scalars, result.closures, result.wall_seconds);
  add_load_cell(json, result.trace);
  json["contact_time_tail_s"] = result.contact_time_tail;
  json["force_averaging_window_s"] = result.force_averaging_window;
  json["setup_s"] = result.setup_seconds;
  json["restitution_momentum"] = result.restitution_momentum;
  json["cells"] = result.cells;
  json["vertices"] = result.vertices;
  json["steps"] = result.steps;
  json["smallest_step_s"] = result.smallest_step;
  json["contact_radius_peak_m"] = result.contact_radius_peak;
  json["vibrational_energy_share"] = result.vibrational_energy_share;
  json["contact_constraint_share"] = result.contact_constraint_share;
  json["kernel"] = result.kernel;
  json["warnings"] = result.warnings;
  return json;
}

Json to_json(const CompressionResult& result) {
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  const CompressionCurve& curve = result.curve;
  const bool slow = curve.time.empty();
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < curve.force.size(); ++i) {
    const double power = std::pow(curve.deflection[i], 1.5);
    product += curve.force[i] * power;
    square += power * power;
  }
  const bool left = !slow && curve.force.back() == 0.0;
  return {
      {"schema", 1},
      {"peak_deflection_m", *std::max_element(curve.deflection.begin(), curve.deflection.end())},
      {"peak_force_N", *std::max_element(curve.force.begin(), curve.force.end())},
      {"contact_radius_peak_m",
       *std::max_element(curve.contact_radius.begin(), curve.contact_radius.end())},
      {"stiffness_N_m1_5", slow ? Json(product / square) : Json(nullptr)},
      {"work_J", curve.work.back()},
      {"stored_J", curve.stored.back()},
      {"friction_J", curve.friction.back()},
      {"contact_end_s", left ? Json(curve.time.back()) : Json(nullptr)},
      {"cells", result.cells},
      {"vertices", result.vertices},
      {"iterations", result.iterations},
      {"wall_s", result.wall_seconds}};
}

Json to_json(const Error& error) {
  const ErrorLocation& at = error.location();
  return {{"schema", 1},
          {"error",
           {{"code", static_cast<int>(error.code())},
            {"message", error.what()},
            {"file", text_or_null(at.file)},
            {"line", place_or_null(at.line)},
            {"column", place_or_null(at.column)},
            {"key", text_or_null(at.key)},
            {"value", text_or_null(at.value)},
            {"allowed", text_or_null(at.allowed)}}}};
}

std::string dump(const Json& json) {
  // A user's file may hold bytes that are no UTF-8; they are shown as U+FFFD.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rebound
