#include "comparisons/inference/calibration/reference_checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr double smallest_range = 1e-6;  // range over peak; a contact goes from nothing to its peak

void check_column(const std::vector<double>& values, const char* what) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw Error(ExitCode::bad_input,
                std::string("a reference trace has a ") + what + " that is not a number");
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (!(*most > 0.0))
    throw Error(ExitCode::bad_input, std::string("a reference trace has no ") + what);
  if (!(*most - *least > smallest_range * *most))
    throw Error(
        ExitCode::bad_input,
        std::string("the ") + what + " of a reference trace is flat: nothing can be identified");
}

}  // namespace

void check_reference(const MeasuredImpact& shot) {
  const Trace& trace = shot.trace;
  if (trace.time.size() < 5 || trace.force.size() != trace.time.size() ||
      trace.deflection.size() != trace.time.size())
    throw Error(ExitCode::bad_input,
                "a calibration needs force and deflection at five instants or more");
  for (std::size_t i = 1; i < trace.time.size(); ++i)
    if (!(trace.time[i] > trace.time[i - 1]))
      throw Error(ExitCode::bad_input, "the time of a reference trace does not go forward",
                  {.key = "time",
                   .value = std::to_string(trace.time[i]),
                   .allowed = "above " + std::to_string(trace.time[i - 1])});
  check_column(trace.force, "force");
  check_column(trace.deflection, "deflection");
}

NoiseKnowledge noise_of(const std::vector<MeasuredImpact>& shots) {
  if (shots.empty()) throw Error(ExitCode::bad_input, "a calibration needs at least one trace");
  const bool all = std::all_of(shots.begin(), shots.end(),
                               [](const auto& shot) { return shot.noise.deviation > 0.0; });
  return all ? NoiseKnowledge::known : NoiseKnowledge::estimated;
}

double weight_of(const MeasuredImpact& shot, NoiseKnowledge noise, Weighting weighting) {
  if (noise == NoiseKnowledge::known) return shot.noise.deviation;
  return weighting == Weighting::of_peak
             ? *std::max_element(shot.trace.force.begin(), shot.trace.force.end())
             : 1.0;
}

}  // namespace rebound
