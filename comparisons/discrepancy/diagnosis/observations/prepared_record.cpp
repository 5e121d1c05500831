#include "comparisons/discrepancy/diagnosis/observations/prepared_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/pull_in_record.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {
namespace {

constexpr double worth_a_warning = 0.3;  // rounding over noise: 5 % of its deviation

/// From before first touch to after separation. The threshold is a share of the peak, not
/// contact_threshold(): the noise is often known only from what lies outside.
///
/// A force that grows as t^p, p ≤ 2, is nothing 1.5 times as long before the lower level as it
/// takes from there to the higher one; a tenth of the contact would be too little for a plate that
/// gives way or a ball with a soft skin, whose onset would pass for noise. More than a quarter of
/// the contact is no onset, but coarse rounding.
SampleRange window_of(const std::vector<double>& force) {
  const double peak = *std::max_element(force.begin(), force.end());
  const SampleRange low = contact_window(force, clearly_in_contact * peak);
  const SampleRange high = contact_window(force, well_in_contact * peak);
  const auto beyond = [&](std::size_t samples) {
    return std::min(samples + (samples + 1) / 2, low.count() / 4);
  };
  // A short record keeps some quiet to tell the noise by, as far as a tenth of the contact allows.
  const std::size_t spare = low.first - std::min(low.first, fewest_quiet);
  const std::size_t before =
      std::min(beyond(high.first - low.first), std::max(spare, low.count() / 10));
  const std::size_t after = beyond(low.last - high.last);
  return {low.first - std::min(low.first, before), std::min(low.last + after, force.size() - 1)};
}

/// Means over blocks of neighbouring samples.
void average(MeasuredImpact& shot, std::size_t block) {
  if (block < 2) return;
  const Trace fine = std::move(shot.trace);
  shot.trace = {};
  shot.noise.deviation /= std::sqrt(static_cast<double>(block));
  shot.deflection_noise.deviation /= std::sqrt(static_cast<double>(block));
  const auto means = [&](const std::vector<double>& column) {
    std::vector<double> coarse;
    for (std::size_t i = 0; i + block <= column.size(); i += block) {
      double sum = 0.0;
      for (std::size_t j = i; j < i + block; ++j) sum += column[j];
      coarse.push_back(sum / static_cast<double>(block));
    }
    return coarse;
  };
  shot.trace.time = means(fine.time);
  shot.trace.force = means(fine.force);
  shot.trace.deflection = means(fine.deflection);
}

/// Adds the noise of rounding, where it is worth a word, to what is stated; one measured on the
/// quiet holds the rounding by itself.
void count_rounding(MeasuredImpact& shot, double rounding, Observations& seen) {
  if (!(rounding > worth_a_warning * shot.noise.deviation)) return;
  seen.warnings.push_back(
      fmt::format("{}: the force is recorded in steps of {:.3g} N; {:.3g} N of rounding count as "
                  "noise",
                  shot.label, rounding * std::sqrt(12.0), rounding));
  if (shot.noise.deviation > 0.0) shot.noise.deviation = std::hypot(shot.noise.deviation, rounding);
}

}  // namespace

double coarse_interval(const Observations& seen, const std::vector<std::size_t>& shots,
                       std::size_t samples) {
  double contacts = 0.0;
  for (const std::size_t i : shots) {
    const Trace& trace = seen.shots[i].trace;
    contacts += static_cast<double>(window_of(trace.force).count()) * mean_sample_step(trace.time);
  }
  return contacts / static_cast<double>(samples * shots.size());
}

Recorder recorder_of(const MeasuredImpact& shot) {
  const std::vector<double>& force = shot.trace.force;
  const std::size_t quiet = window_of(force).first;
  return {.step = quantisation_step(force),
          .scatter = quiet < fewest_quiet
                         ? shot.noise.deviation
                         : estimate_noise({std::span(force.data(), quiet)}).deviation};
}

std::size_t samples_told(const MeasuredImpact& shot, const Recorder& recorder) {
  constexpr double fewest_told = 30.0;
  const double peak = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
  return static_cast<std::size_t>(std::max(fewest_told, 2.0 * peak / recorder.step));
}

PreparedRecord prepare_record(std::size_t index, double interval, const Recorder& recorder,
                              Observations& seen) {
  MeasuredImpact& shot = seen.shots[index];
  count_rounding(shot, recorder.rounding(), seen);
  constexpr double rounded = 1e-6;  // two intervals of 10 us are 20 us
  average(shot, static_cast<std::size_t>(interval / mean_sample_step(shot.trace.time) + rounded));
  PreparedRecord record{
      .shot = index, .trace = std::move(shot.trace), .contact = {}, .recorder = recorder};
  shot.trace = {};
  record.contact =
      with_pull(window_of(record.trace.force), record.trace.force, recorder.rounding());
  return record;
}

}  // namespace rebound
