#include "comparisons/models/instrument/reported_force.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/models/instrument/butterworth.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Force at one instant; `from` is where the last search ended.
double force_at(const Trace& trace, double time, std::size_t& from) {
  if (time < trace.time.front() || time > trace.time.back()) return 0.0;
  while (from + 2 < trace.time.size() && trace.time[from + 1] < time) ++from;
  const double span = trace.time[from + 1] - trace.time[from];
  const double share = (time - trace.time[from]) / span;
  return (1.0 - share) * trace.force[from] + share * trace.force[from + 1];
}

/// The filtered contact on an even grid that reaches as far as `last`.
Trace filtered(const Trace& contact, double bandwidth, double last) {
  const double duration = contact.time.back() - contact.time.front();
  const double step = duration / static_cast<double>(contact.time.size() - 1);
  const double end = std::max(last, contact.time.back());
  Trace even;
  std::size_t from = 0;
  for (double t = contact.time.front(); t <= end + step; t += step) {
    even.time.push_back(t);
    even.force.push_back(force_at(contact, t, from));
  }
  even.force = Butterworth({.corner = bandwidth, .sampling_rate = 1.0 / step}).filter(even.force);
  return even;
}

}  // namespace

std::vector<double> reported_force(const Trace& contact, const MeasurementChain& chain,
                                   std::span<const double> time) {
  if (contact.time.size() < 2)
    throw Error(ExitCode::bad_input, "a contact needs at least two samples");
  if (time.empty()) return {};
  const bool ideal = std::isinf(chain.bandwidth);
  const Trace passed =
      ideal ? Trace{} : filtered(contact, chain.bandwidth, time.back() - chain.trigger_shift);
  const Trace& source = ideal ? contact : passed;
  std::vector<double> force;
  force.reserve(time.size());
  std::size_t from = 0;
  for (const double t : time)
    force.push_back((1.0 + chain.force_gain) * force_at(source, t - chain.trigger_shift, from) +
                    chain.force_baseline);
  return force;
}

}  // namespace rebound
