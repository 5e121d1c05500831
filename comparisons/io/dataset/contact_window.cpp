#include "comparisons/io/dataset/contact_window.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {

double contact_threshold(const MeasuredImpact& record) {
  if (record.contact_threshold) return *record.contact_threshold;
  return 3.0 * record.noise.deviation;
}

SampleRange contact_window(const std::vector<double>& force, double threshold) {
  SampleRange range{0, force.size()};
  while (range.first < force.size() && !(force[range.first] > threshold)) ++range.first;
  if (range.first == force.size())
    throw Error(ExitCode::bad_input,
                fmt::format("the force of a trace never exceeds {:.3g} N", threshold));
  while (!(force[--range.last] > threshold)) {
  }
  return range;
}

SampleRange widened(const SampleRange& range, std::size_t margin, std::size_t samples) {
  return {range.first - std::min(range.first, margin), std::min(range.last + margin, samples - 1)};
}

Trace cut(const Trace& trace, const SampleRange& range) {
  Trace part;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    part.time.push_back(trace.time[i] - trace.time[range.first]);
    part.force.push_back(trace.force[i]);
    if (!trace.deflection.empty()) part.deflection.push_back(trace.deflection[i]);
  }
  return part;
}

Trace cut_at(const Trace& trace, double end) {
  Trace part;
  for (std::size_t i = 0; i < trace.time.size() && trace.time[i] <= end; ++i) {
    part.time.push_back(trace.time[i]);
    part.force.push_back(trace.force[i]);
    part.deflection.push_back(trace.deflection[i]);
  }
  return part;
}

double reported_contact_time(const Trace& trace, double by_separation_rule, double threshold) {
  return threshold > 0.0 ? time_above(trace, threshold) : by_separation_rule;
}

}  // namespace rebound
