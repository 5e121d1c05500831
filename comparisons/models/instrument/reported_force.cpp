#include "comparisons/models/instrument/reported_force.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/models/instrument/butterworth.hpp"
#include "comparisons/models/instrument/channel_filter.hpp"
#include "comparisons/models/instrument/disturbance.hpp"
#include "comparisons/models/instrument/droop.hpp"
#include "comparisons/models/instrument/lag.hpp"
#include "comparisons/models/instrument/sample_step.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Rate of the force at sample i: that of the parabola through it and its neighbours, or through
/// the three samples at an end.
double rate_at(const Trace& trace, std::size_t i) {
  const std::size_t last = trace.time.size() - 1;
  const auto chord = [&](std::size_t k) {
    return (trace.force[k + 1] - trace.force[k]) / (trace.time[k + 1] - trace.time[k]);
  };
  if (last < 2) return chord(0);
  const std::size_t left = std::clamp<std::size_t>(i, 1, last - 1) - 1;
  const double before = trace.time[left + 1] - trace.time[left];
  const double after = trace.time[left + 2] - trace.time[left + 1];
  const double bend = (chord(left + 1) - chord(left)) / (before + after);
  if (i == 0) return chord(0) - before * bend;
  if (i == last) return chord(last - 1) + after * bend;
  return chord(left) + before * bend;
}

/// Force at one instant, by the cubic of Hermite; `from` is where the last search ended.
double force_at(const Trace& trace, double time, std::size_t& from) {
  if (time < trace.time.front() || time > trace.time.back()) return 0.0;
  while (from + 2 < trace.time.size() && trace.time[from + 1] < time) ++from;
  const double span = trace.time[from + 1] - trace.time[from];
  const double s = (time - trace.time[from]) / span, rest = 1.0 - s;
  const double rise = trace.force[from + 1] - trace.force[from];
  const double leaving = span * rate_at(trace, from) - rise;
  const double arriving = rise - span * rate_at(trace, from + 1);
  return rest * trace.force[from] + s * trace.force[from + 1] +
         s * rest * (rest * leaving + s * arriving);
}

/// Its mean over an aperture about that instant, where the contact ends within it; but for a jump
/// there, which stays one. A mean over an instant within the contact is its middle. Where the force
/// ends with a slope, a reading changes with that instant without a bend. Where it begins it may
/// rise as steeply as a jump, and stays as it is.
double mean_at(const Trace& trace, double time, double aperture, std::size_t& from) {
  const double half = 0.5 * aperture, last = trace.time.back();
  const double begin = std::max(time - half, trace.time.front());
  if (time + half <= last || begin >= last) return force_at(trace, time, from);
  const double before = force_at(trace, begin, from), at_end = trace.force.back();
  const double slope_part = 0.5 * (before - at_end) * (last - begin) / aperture;
  return slope_part + (time <= last ? at_end : 0.0);
}

/// The contact on an even grid, zero around it.
Trace on_even_grid(const Trace& contact, double first, double last, double step) {
  Trace even;
  std::size_t from = 0;
  for (double t = first; t <= last + step; t += step) {
    even.time.push_back(t);
    even.force.push_back(force_at(contact, t, from));
  }
  return even;
}

constexpr double most_steps = 1e5;

/// The filtered contact on an even grid that reaches as far as `last`.
Trace filtered(const Trace& contact, double bandwidth, double last) {
  const double end = std::max(last, contact.time.back());
  const double step = sample_step(contact, end - contact.time.front(), most_steps);
  Trace even = on_even_grid(contact, contact.time.front(), end, step);
  even.force = Butterworth({.corner = bandwidth, .sampling_rate = 1.0 / step}).filter(even.force);
  return even;
}

/// Behind a filter without delay, which smears a contact over the time before it, too.
Trace filtered_by_class(const Trace& contact, double filter_class, double last) {
  const double reach = 1.0 / filter_class, first = contact.time.front() - reach;
  const double end = std::max(last, contact.time.back() + reach);
  // Fine enough for the filter, however coarse the contact is sampled.
  const double step = std::min(sample_step(contact, end - first, most_steps), 0.05 / filter_class);
  Trace even = on_even_grid(contact, first, end, step);
  even.force = channel_filtered(even.force, step, filter_class);
  return even;
}

/// What the filters of the chain make of the contact; `last` by the contact's own clock.
Trace passed_by_filters(const Trace& contact, const MeasurementChain& chain, double last) {
  const double step = mean_sample_step(contact.time);
  // A cut-off above the samples' own rate changes nothing that they could show.
  constexpr double highest_share = 0.45;
  Trace passed = contact;
  if (chain.bandwidth < highest_share / step) passed = filtered(passed, chain.bandwidth, last);
  for (const double lag : {chain.lag, chain.second_lag})
    if (lag != 0.0) passed = with_lag(passed, lag, last);
  if (chain.droop != 0.0) passed = with_droop(passed, chain.droop, last);
  if (chain.filter_class > 0.0) passed = filtered_by_class(passed, chain.filter_class, last);
  return passed;
}

}  // namespace

std::vector<double> reported_force(const Trace& contact, const MeasurementChain& chain,
                                   std::span<const double> time) {
  if (contact.time.size() < 2)
    throw Error(ExitCode::bad_input, "a contact needs at least two samples");
  require_limits(chain, {.name = "measurement"});
  if (time.empty()) return {};
  const auto since_touch = [&](double t) {
    return (t - chain.trigger_shift) / (1.0 + chain.time_base);
  };
  const bool ideal = std::isinf(chain.bandwidth) && chain.droop == 0.0 && chain.lag == 0.0 &&
                     chain.second_lag == 0.0 && chain.filter_class == 0.0;
  const Trace passed =
      ideal ? Trace{} : passed_by_filters(contact, chain, since_touch(time.back()));
  const Trace& source = ideal ? contact : passed;
  std::vector<double> force;
  force.reserve(time.size());
  std::size_t from = 0;
  for (const double t : time) {
    const double since = since_touch(t);
    const double reading = (1.0 + chain.force_gain) * mean_at(source, since, chain.aperture, from) +
                           added_force(chain, since);
    force.push_back(std::min(reading, chain.clipping_level));
  }
  return force;
}

}  // namespace rebound
