#include "lumped/problem/scalars.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

double refined_peak(const std::vector<double>& time, const std::vector<double>& value) {
  const auto highest = std::max_element(value.begin(), value.end());
  const auto i = static_cast<std::size_t>(highest - value.begin());
  if (i == 0 || i + 1 == value.size()) return *highest;
  // Newton form of the parabola through (i-1, i, i+1).
  const double left = (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
  const double right = (value[i + 1] - value[i]) / (time[i + 1] - time[i]);
  const double curvature = (right - left) / (time[i + 1] - time[i - 1]);
  if (curvature >= 0.0) return *highest;
  const double slope = left + curvature * (time[i] - time[i - 1]);
  return *highest - 0.25 * slope * slope / curvature;
}

double integral(const std::vector<double>& time, const std::vector<double>& value) {
  double sum = 0.0;
  for (std::size_t i = 1; i < time.size(); ++i)
    sum += 0.5 * (value[i] + value[i - 1]) * (time[i] - time[i - 1]);
  return sum;
}

double time_above(const std::vector<double>& t, const std::vector<double>& f, double threshold) {
  const auto crossing = [&](std::size_t below, std::size_t above) {
    return t[below] + (t[above] - t[below]) * (threshold - f[below]) / (f[above] - f[below]);
  };
  std::size_t first = 0;
  while (first < f.size() && f[first] < threshold) ++first;
  if (first == f.size()) return 0.0;
  std::size_t last = f.size() - 1;
  while (f[last] < threshold) --last;
  const double start = first == 0 ? t.front() : crossing(first - 1, first);
  const double end = last + 1 == f.size() ? t.back() : crossing(last + 1, last);
  return end - start;
}

double time_above(const Trace& trace, double threshold) {
  return time_above(trace.time, trace.force, threshold);
}

const std::vector<double>& contact_force(const Trace& trace) {
  const auto column =
      std::find_if(trace.further.begin(), trace.further.end(),
                   [](const TraceColumn& c) { return c.name == contact_force_column; });
  return column == trace.further.end() ? trace.force : column->values;
}

ImpactScalars derive_scalars(const Trace& trace, const Impact& impact, double separation_time,
                             double rebound_speed) {
  const std::size_t n = trace.time.size();
  if (n < 3 || trace.force.size() != n || trace.deflection.size() != n)
    throw Error(ExitCode::bad_input,
                "a trace needs at least three samples and columns of equal length");
  ImpactScalars scalars;
  scalars.separation = impact.separation;
  scalars.contact_time = separation_time;
  scalars.rebound_speed = rebound_speed;
  scalars.restitution = rebound_speed / impact.speed;
  const std::vector<double>& force = contact_force(trace);
  if (force.size() != n) throw Error(ExitCode::bad_input, "a trace needs columns of equal length");
  scalars.peak_force = refined_peak(trace.time, force);
  scalars.peak_deflection = refined_peak(trace.time, trace.deflection);
  scalars.contact_time_1pct = time_above(trace.time, force, 0.01 * scalars.peak_force);
  double area = 0.0;
  for (std::size_t i = 1; i < n && trace.time[i - 1] < separation_time; ++i) {
    const double end = std::min(trace.time[i], separation_time);
    const double fraction = (end - trace.time[i - 1]) / (trace.time[i] - trace.time[i - 1]);
    const double at_end =
        trace.deflection[i - 1] + fraction * (trace.deflection[i] - trace.deflection[i - 1]);
    area += 0.5 * (trace.deflection[i - 1] + at_end) * (end - trace.time[i - 1]);
  }
  scalars.mean_deflection = area / separation_time;
  return scalars;
}

}  // namespace rebound
