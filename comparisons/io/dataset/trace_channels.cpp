#include "comparisons/io/dataset/trace_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparisons/io/dataset/contact_window.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t fewest_quiet = 10;

/// Mean instant and mean force of some samples.
struct Mean {
  double time = 0.0, force = 0.0;
};

Mean mean_of(const Trace& trace, std::size_t from, std::size_t to, const char* where) {
  if (to < from + fewest_quiet)
    throw Error(ExitCode::bad_input,
                fmt::format("there are {} samples {} contact to take the baseline from; {} are "
                            "needed",
                            to > from ? to - from : 0, where, fewest_quiet),
                {.key = "channels.baseline"});
  const auto mean = [&](const std::vector<double>& column) {
    return std::accumulate(column.begin() + static_cast<std::ptrdiff_t>(from),
                           column.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
           static_cast<double>(to - from);
  };
  return {mean(trace.time), mean(trace.force)};
}

/// The contact, found after the largest offset is out of the way.
SampleRange contact_of(const std::vector<double>& force) {
  std::vector<double> sorted = force;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double highest = *std::max_element(force.begin(), force.end());
  // The median is the quiet of a long record; in a short one it may lie on the contact.
  const double quiet = std::min(*middle, std::max(force.front(), force.back()));
  return contact_window(force, quiet + clearly_in_contact * (highest - quiet));
}

void take_out_baseline(Baseline baseline, Trace& trace) {
  if (baseline == Baseline::as_recorded) return;
  const SampleRange contact = contact_of(trace.force);
  const std::size_t length = contact.count();
  const Mean before =
      mean_of(trace, 0, contact.first - std::min(contact.first, length / 4 + 1), "before");
  double slope = 0.0;
  if (baseline == Baseline::before_and_after) {
    const std::size_t from = std::min(trace.time.size(), contact.last + 1 + length);
    const Mean after = mean_of(trace, from, trace.time.size(), "after");
    slope = (after.force - before.force) / (after.time - before.time);
  }
  for (std::size_t i = 0; i < trace.time.size(); ++i)
    trace.force[i] -= before.force + slope * (trace.time[i] - before.time);
}

void keep_around_contact(Trace& trace) {
  constexpr std::size_t lengths_before = 5, lengths_after = 2;
  const SampleRange contact = contact_of(trace.force);
  const std::size_t first =
      contact.first - std::min(contact.first, lengths_before * contact.count());
  const std::size_t last =
      std::min(trace.time.size() - 1, contact.last + lengths_after * contact.count());
  for (std::vector<double>* column : {&trace.time, &trace.force, &trace.deflection}) {
    if (column->empty()) continue;
    column->erase(column->begin() + static_cast<std::ptrdiff_t>(last) + 1, column->end());
    column->erase(column->begin(), column->begin() + static_cast<std::ptrdiff_t>(first));
  }
}

}  // namespace

void settle_record(const TraceChannels& channels, Trace& trace) {
  if (channels.reversed)
    for (double& force : trace.force) force = -force;
  const auto extremes = std::minmax_element(trace.force.begin(), trace.force.end());
  const double lowest = *extremes.first, highest = *extremes.second;
  // Seen from either end, so that an offset is no sign, nor a record that starts or ends in
  // contact.
  const auto swings_down = [&](double quiet) { return quiet - lowest > highest - quiet; };
  if (swings_down(trace.force.front()) && swings_down(trace.force.back()))
    throw Error(ExitCode::bad_input,
                "the force is negative where it is largest; a force is positive in compression",
                {.key = "channels.reversed",
                 .value = channels.reversed ? "true" : "false",
                 .allowed = channels.reversed ? "false" : "true"});
  take_out_baseline(channels.baseline, trace);
  if (channels.keep == KeptRecord::around_contact) keep_around_contact(trace);
}

}  // namespace rebound
