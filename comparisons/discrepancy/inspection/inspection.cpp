#include "comparisons/discrepancy/inspection/inspection.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

#include "comparisons/discrepancy/diagnosis/data_checks/checked_shots.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/force_before_touch.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/observations/quantisation.hpp"
#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"
#include "comparisons/discrepancy/inspection/shots_together.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/models/instrument/channel_filter.hpp"
#include "comparisons/models/instrument/sample_step.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

using Source = InspectedNumber::Source;

constexpr std::size_t fewest_in_contact = 20, fewest_before_contact = 20;
constexpr double coarsest_share = 0.05;  // of the peak: noise, step of the recorder
constexpr double least_bandwidth = 2.0;  // times the contact time

struct NamedNumber {
  RecordNumber number;
  const char* key;
};
constexpr NamedNumber numbers_of_record[] = {
    {RecordNumber::peak_force, "peak_force_N"},
    {RecordNumber::contact_time, "contact_time_s"},
    {RecordNumber::width, "width_at_three_tenths_s"},
    {RecordNumber::impulse, "impulse_N_s"},
    {RecordNumber::work, "work_J"},
    {RecordNumber::peak_deflection, "peak_deflection_m"},
    {RecordNumber::force_over_inertia, "force_over_inertia"},
    {RecordNumber::approach_speed, "approach_speed_from_deflection_m_s"},
};

constexpr const char* scalar_units[] = {"", "_s", "_N", "_m", "_m"};

void add_stated(const MeasuredImpact& shot, InspectedShot& seen) {
  for (std::size_t i = 0; i < scalar_quantities.size(); ++i) {
    const Measured& stated = shot.*scalar_quantities[i].measured;
    if (stated.value)
      seen.numbers.push_back({std::string("stated_") + scalar_quantities[i].key + scalar_units[i],
                              *stated.value, stated.uncertainty, Source::stated});
  }
}

/// Restitution from the impulse alone: ∫ F dt = m v (1 + e).
void add_restitution(const CheckedShot& one, const Observations& all, InspectedShot& seen) {
  const RecordReading& impulse = one.reading(RecordNumber::impulse);
  if (!impulse.is_known()) return;
  const MeasuredImpact& shot = *one.shot;
  const double ratio = impulse.value / (shot.sphere.mass * shot.impact.speed);
  const double relative =
      std::sqrt(std::pow(impulse.error() / impulse.value, 2) + std::pow(all.gain_uncertainty, 2) +
                std::pow(shot.speed_uncertainty.value_or(0.0) / shot.impact.speed, 2) +
                std::pow(all.balls[shot.ball].mass_uncertainty / shot.sphere.mass, 2));
  seen.numbers.push_back(
      {"restitution_from_impulse", ratio - 1.0, ratio * relative, Source::record});
}

void add_record_numbers(const CheckedShot& one, const Observations& all, InspectedShot& seen) {
  for (const NamedNumber& named : numbers_of_record) {
    const RecordReading& reading = one.reading(named.number);
    if (reading.is_known())
      seen.numbers.push_back({named.key, reading.value, reading.error(), Source::record});
  }
  add_restitution(one, all, seen);
}

/// Top of the parabola by least squares through the samples above 0.85 of the largest: the highest
/// of noisy samples would lie above the peak, and every filter would seem to lower it.
double smooth_peak(const Trace& trace, const std::vector<double>& force) {
  constexpr double share_at_the_top = 0.85;
  const auto top = std::max_element(force.begin(), force.end());
  const double centre = trace.time[static_cast<std::size_t>(top - force.begin())];
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const SampleRange range = contact_window(force, share_at_the_top * *top);
  if (range.count() < 4) return refined_peak(trace.time, force);
  const double scale = trace.time[range.last] - trace.time[range.first];
  for (std::size_t i = range.first; i <= range.last; ++i) {
    const double t = (trace.time[i] - centre) / scale;
    const Eigen::Vector3d powers(1.0, t, t * t);
    normal += powers * powers.transpose();
    right += force[i] * powers;
  }
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  return fit[2] < 0.0 ? fit[0] - fit[1] * fit[1] / (4.0 * fit[2]) : *top;
}

/// Peaks by parabola before and after each filter that the sampling allows.
void add_filters(const Trace& trace, InspectedShot& seen) {
  const double peak = smooth_peak(trace, trace.force);
  for (const double channel_class : channel_classes) {
    if (seen.interval * 10.0 * channel_class > 1.0) continue;
    const auto filtered = channel_filtered(trace.force, seen.interval, channel_class);
    seen.filters.push_back({channel_class, smooth_peak(trace, filtered) / peak - 1.0});
  }
}

void judge_record(const MeasuredImpact& shot, const Dataset& dataset, std::size_t before,
                  InspectedShot& seen) {
  const double peak = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
  const double contact = static_cast<double>(seen.samples_in_contact) * seen.interval;
  const auto say = [&](const std::string& text) { seen.too_coarse.push_back(text); };
  if (seen.samples_in_contact < fewest_in_contact)
    say(fmt::format("{} samples in contact: half a sample is {:.2g} % of the contact time",
                    seen.samples_in_contact,
                    50.0 / static_cast<double>(std::max<std::size_t>(1, seen.samples_in_contact))));
  if (before < fewest_before_contact)
    say(fmt::format("{} samples before contact: they tell neither noise nor zero", before));
  if (seen.noise > coarsest_share * peak)
    say(fmt::format("noise of a sample is {:.2g} % of the peak", 100.0 * seen.noise / peak));
  if (seen.rounding_step > coarsest_share * peak)
    say(fmt::format("a step of the recorder is {:.2g} % of the peak",
                    100.0 * seen.rounding_step / peak));
  const auto& bandwidth = dataset.instrument.force_bandwidth;
  if (bandwidth && *bandwidth * contact < least_bandwidth)
    say(fmt::format("a bandwidth of {:.3g} Hz is {:.2g} over the contact time: peaks are lowered",
                    *bandwidth, *bandwidth * contact));
}

/// The shot as it was recorded, before a diagnosis cuts and averages it.
InspectedShot inspect_recorded(const Dataset& dataset, const MeasuredImpact& shot,
                               std::vector<std::span<const double>>& quiet) {
  InspectedShot seen;
  seen.speed = shot.impact.speed;
  seen.speed_uncertainty = shot.speed_uncertainty;
  add_stated(shot, seen);
  if (!shot.has_history()) return seen;
  const std::vector<double>& force = shot.trace.force;
  const double peak = *std::max_element(force.begin(), force.end());
  if (!(peak > 0.0)) {
    seen.samples = force.size();
    seen.too_coarse.push_back("there is no impact in the record");
    return seen;
  }
  const SampleRange contact = contact_window(force, clearly_in_contact * peak);
  seen.samples = force.size();
  seen.samples_in_contact = contact.count();
  seen.interval = mean_sample_step(shot.trace.time);
  seen.rounding_step = quantisation_step(force);
  const std::size_t before = contact.first - std::min(contact.first, contact.count() / 10 + 1);
  quiet.emplace_back(force.data(), before);
  seen.noise = before < fewest_before_contact ? dataset.instrument.force_noise.value_or(0.0)
                                              : estimate_noise({quiet.back()}).deviation;
  add_filters(shot.trace, seen);
  judge_record(shot, dataset, before, seen);
  return seen;
}

void add_noise(const Observations& seen, const std::vector<std::span<const double>>& quiet,
               Inspection& found) {
  found.noise.from = seen.noise_from;
  if (quiet.empty()) return;
  const EstimatedNoise noise = estimate_noise(quiet);
  found.noise.deviation = noise.deviation;
  found.noise.samples = noise.samples;
  found.noise.autocorrelation = noise.autocorrelation;
  for (const InspectedShot& shot : found.shots)
    if (shot.interval > 0.0) found.noise.interval = shot.interval;
}

}  // namespace

Inspection inspect(const Dataset& dataset) {
  Inspection found;
  found.name = dataset.name;
  std::vector<std::span<const double>> quiet;
  std::vector<MeasuredImpact> shots = dataset.shots;
  take_out_zero_offset(shots);
  for (const MeasuredImpact& shot : shots)
    found.shots.push_back(inspect_recorded(dataset, shot, quiet));
  const Observations seen = observe({dataset});
  for (std::size_t i = 0; i < found.shots.size(); ++i)
    found.shots[i].label = fmt::format("shot {}, {:.4g} m/s", i + 1, found.shots[i].speed);
  const std::vector<CheckedShot> checked = checked_shots(seen);
  for (const CheckedShot& one : checked) {
    const auto index = static_cast<std::size_t>(one.shot->number) - 1;
    if (index < found.shots.size()) add_record_numbers(one, seen, found.shots[index]);
  }
  add_noise(seen, quiet, found);
  add_repeats(found);
  found.checks = check_data(seen);
  if (const auto check = force_before_touch(dataset)) found.checks.push_back(*check);
  add_restitution_checks(seen, found);
  found.contradictions = contradictions_among(found.checks);
  found.contradiction_limit = contradiction_limit(found.checks.size());
  found.warnings = seen.warnings;
  found.missing = seen.missing;
  return found;
}

}  // namespace rebound
