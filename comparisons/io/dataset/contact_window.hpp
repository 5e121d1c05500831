#pragma once

#include <cstddef>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

/// When a recorded contact starts and ends: the one definition of it.
namespace rebound {

/// Shares of the peak force: above the first a record is in contact, whatever its noise; the second
/// shows how steep it starts, and tells one impact from the next.
inline constexpr double clearly_in_contact = 0.1, well_in_contact = 0.3;

/// Neighbouring samples of a record, both ends included.
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;

  std::size_t count() const { return last - first + 1; }
};

/// The force above which a record counts as contact [N]: the instrument's threshold, or three
/// standard deviations of its noise, or zero.
double contact_threshold(const MeasuredImpact& record);

/// Samples from the first to the last force above a threshold, whatever lies between.
/// Errors: Error(bad_input) for a force that never exceeds it.
SampleRange contact_window(const std::vector<double>& force, double threshold);

/// The range with `margin` samples more at either end, as far as the record goes.
SampleRange widened(const SampleRange& range, std::size_t margin, std::size_t samples);

/// The samples of a range with time from zero.
Trace cut(const Trace& trace, const SampleRange& range);

/// A solver's trace up to an instant: its record goes on after separation.
Trace cut_at(const Trace& trace, double end);

/// Contact time as an instrument reports it: above its threshold where it has one, otherwise
/// that of the separation rule [s].
///
/// Caution: the time above zero of a solver's trace is the length of its record.
double reported_contact_time(const Trace& trace, double by_separation_rule, double threshold);

}  // namespace rebound
