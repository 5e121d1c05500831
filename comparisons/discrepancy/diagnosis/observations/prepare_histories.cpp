#include "comparisons/discrepancy/diagnosis/observations/prepare_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "comparisons/discrepancy/diagnosis/observations/quantisation.hpp"
#include "comparisons/discrepancy/diagnosis/observations/settle_deflections.hpp"
#include "comparisons/discrepancy/diagnosis/observations/whole_impact.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

// A contact; fewer where shots are many: a shape takes a hundred, and noise is averaged with it.
constexpr std::size_t most_samples = 600, fewest_samples = 150, most_samples_in_all = 6000;
constexpr double worth_a_warning = 0.3;   // rounding over noise: 5 % of its deviation
constexpr std::size_t fewest_quiet = 20;  // samples before contact that make a scatter

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

/// How fine the readings of a record are.
struct Recorder {
  double step = 0.0;     ///< of rounding; 0: none is seen [N]
  double scatter = 0.0;  ///< of readings in the quiet, or what is stated [N]

  double rounding() const { return quantisation_noise(step); }
  /// Up to twice the scatter errors of rounding are noise of their own, whatever else there is.
  bool is_coarse() const { return step > 2.0 * scatter; }
};

/// A whole record, made coarse enough, and where its contact is.
struct Record {
  std::size_t shot = 0;  ///< index among the observations
  Trace trace;
  SampleRange contact;
  Recorder recorder;

  std::span<const double> quiet() const { return {trace.force.data(), contact.first}; }
};

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

double interval_of(const Trace& trace) {
  return (trace.time.back() - trace.time.front()) / static_cast<double>(trace.time.size() - 1);
}

/// Interval between samples that leaves so many of a contact, on average over these shots [s]. One
/// for all: noise has another colour where it is averaged over more samples.
double coarse_interval(const Observations& seen, const std::vector<std::size_t>& shots,
                       std::size_t samples) {
  double contacts = 0.0;
  for (const std::size_t i : shots) {
    const Trace& trace = seen.shots[i].trace;
    contacts += static_cast<double>(window_of(trace.force).count()) * interval_of(trace);
  }
  return contacts / static_cast<double>(samples * shots.size());
}

/// The scatter is that while nothing happens, or else what is stated; 0: neither is known.
Recorder recorder_of(const MeasuredImpact& shot) {
  const std::vector<double>& force = shot.trace.force;
  const std::size_t quiet = window_of(force).first;
  return {.step = quantisation_step(force),
          .scatter = quiet < fewest_quiet
                         ? shot.noise.deviation
                         : estimate_noise({std::span(force.data(), quiet)}).deviation};
}

/// Samples of a contact that a coarse recorder tells: as many as it has steps on the way up and
/// down, for errors within one step are alike.
std::size_t samples_told(const MeasuredImpact& shot, const Recorder& recorder) {
  constexpr double fewest_told = 30.0;
  const double peak = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
  return static_cast<std::size_t>(std::max(fewest_told, 2.0 * peak / recorder.step));
}

Record prepare_record(std::size_t index, double interval, const Recorder& recorder,
                      Observations& seen) {
  MeasuredImpact& shot = seen.shots[index];
  count_rounding(shot, recorder.rounding(), seen);
  constexpr double rounded = 1e-6;  // two intervals of 10 us are 20 us
  average(shot, static_cast<std::size_t>(interval / interval_of(shot.trace) + rounded));
  Record record{.shot = index, .trace = std::move(shot.trace), .contact = {}, .recorder = recorder};
  shot.trace = {};
  record.contact = window_of(record.trace.force);
  return record;
}

/// Does the scatter of the quiet contradict a stated deviation?
bool contradicts(const EstimatedNoise& noise, double stated, double independent) {
  // Three standard errors of the scatter, and no less than a fifth.
  const double slack = std::max(0.2, 3.0 / std::sqrt(2.0 * independent));
  return std::abs(std::log(noise.deviation / stated)) > slack;
}

/// Colour of the noise of all records of a data set, and its size where it has a colour, or where
/// what they scatter by contradicts what is stated; the scatter of each shot alone where nothing is
/// stated. The size that belongs to a colour is the one that was found with it.
void settle_noise(const std::string& dataset, const std::vector<Record>& records,
                  Observations& seen) {
  std::vector<std::span<const double>> stretches;
  stretches.reserve(records.size());
  for (const Record& record : records) stretches.push_back(record.quiet());
  const EstimatedNoise noise = estimate_noise(stretches);
  constexpr int fewest_for_colour = 40;
  const bool enough = noise.samples >= fewest_for_colour && noise.deviation > 0.0;
  if (!enough)
    seen.warnings.push_back(dataset +
                            ": too few samples before contact to check the noise; it is taken as "
                            "white and of the stated size");
  const bool coloured = enough && !noise.autocorrelation.empty();
  const double independent =
      std::max(2.0, noise.samples * effective_share_of_variance(noise.autocorrelation));
  bool estimated = coloured;
  for (const Record& record : records) {
    MeasuredImpact& shot = seen.shots[record.shot];
    const double stated = shot.noise.deviation;
    if (enough) shot.noise.autocorrelation = noise.autocorrelation;
    if (stated > 0.0) {
      seen.noise_from = "stated by the data set";
      const bool wrong = enough && contradicts(noise, stated, independent);
      if (wrong && &record == &records.front())
        seen.warnings.push_back(fmt::format(
            "{}: the force scatters by {:.3g} N before contact, where {:.3g} N are stated; the "
            "scatter is taken",
            dataset, noise.deviation, stated));
      if (!wrong && !coloured) continue;
      shot.noise.deviation = noise.deviation;
      estimated = true;
      seen.noise_from = "scatter of the force before contact";
      if (wrong) seen.noise_from += ", which contradicts what is stated";
    } else if (enough) {
      shot.noise.deviation = std::max(noise.deviation, record.recorder.rounding());
      seen.noise_from = "scatter of the force before contact";
      estimated = true;
    } else if (record.contact.first >= fewest_quiet) {
      // Without anything else, a recorder rounds to one level again and again.
      shot.noise.deviation =
          std::max(estimate_noise({record.quiet()}).deviation, record.recorder.rounding());
      seen.noise_from = "scatter of the force before contact";
      estimated = true;
    }
  }
  // What is compared is the part of each sample that its neighbours do not tell.
  if (estimated)
    seen.noise_freedom +=
        std::max(2.0, noise.samples - static_cast<double>(noise.autocorrelation.size()) - 2.0);
  if (coloured)
    seen.noise_from += fmt::format(
        "; neighbouring samples are alike (correlation {:.2g}), autoregressive of order {}",
        noise.autocorrelation.front(), noise.autocorrelation.size());
}

/// A recorder that rounds to one level again and again hides size and colour of all other noise.
/// Its errors are bounded by half a step and alike within one, so that no mean makes them less.
void settle_coarse_noise(const std::vector<Record>& records, Observations& seen) {
  for (const Record& record : records) {
    seen.shots[record.shot].noise.deviation =
        std::hypot(record.recorder.scatter, 0.5 * record.recorder.step);
    seen.coarse_step = std::max(seen.coarse_step, record.recorder.step);
  }
  seen.noise_from = "rounding of the recorder, whose steps are more than twice all other noise";
}

/// Mean of the force before contact, and how well it is known.
void settle_zero(const Record& record, ForceNoise& noise) {
  const std::span<const double> quiet = record.quiet();
  if (quiet.size() < fewest_quiet || !(noise.deviation > 0.0)) return;
  const auto count = static_cast<double>(quiet.size());
  noise.zero = std::accumulate(quiet.begin(), quiet.end(), 0.0) / count;
  const double independent = std::max(1.0, count * effective_share(noise.autocorrelation));
  noise.zero_error = noise.deviation / std::sqrt(independent);
}

/// Leaves the contact with some of the quiet before and after it; no history where nothing
/// tells the noise.
void keep_contact(const Record& record, MeasuredImpact& shot) {
  if (!(shot.noise.deviation > 0.0)) return;
  const SampleRange kept =
      widened(record.contact, record.contact.count() / 10, record.trace.time.size());
  const auto part = [&](const std::vector<double>& column) {
    const auto begin = column.begin();
    return std::vector<double>(begin + static_cast<std::ptrdiff_t>(kept.first),
                               begin + static_cast<std::ptrdiff_t>(kept.last) + 1);
  };
  shot.trace.time = part(record.trace.time);
  shot.trace.force = part(record.trace.force);
  if (shot.deflection_noise.deviation > 0.0) shot.trace.deflection = part(record.trace.deflection);
}

}  // namespace

void prepare_histories(const Dataset& dataset, std::size_t first, Observations& seen) {
  for (std::size_t i = first; i < seen.shots.size(); ++i)
    if (seen.shots[i].has_history()) keep_whole_impact(seen.shots[i], seen.warnings);
  std::vector<std::size_t> histories;
  for (std::size_t i = first; i < seen.shots.size(); ++i)
    if (seen.shots[i].has_history()) histories.push_back(i);
  if (histories.empty()) return;
  std::size_t samples =
      std::clamp(most_samples_in_all / histories.size(), fewest_samples, most_samples);
  std::vector<Recorder> recorders;
  recorders.reserve(histories.size());
  for (const std::size_t i : histories) {
    const Recorder& one = recorders.emplace_back(recorder_of(seen.shots[i]));
    if (one.is_coarse()) samples = std::min(samples, samples_told(seen.shots[i], one));
  }
  const bool coarse = std::any_of(recorders.begin(), recorders.end(),
                                  [](const Recorder& one) { return one.is_coarse(); });
  const double interval = coarse_interval(seen, histories, samples);
  std::vector<Record> records;
  records.reserve(histories.size());
  for (std::size_t k = 0; k < histories.size(); ++k)
    records.push_back(prepare_record(histories[k], interval, recorders[k], seen));
  if (coarse)
    settle_coarse_noise(records, seen);
  else
    settle_noise(dataset.name, records, seen);
  std::vector<WholeRecord> whole;
  whole.reserve(records.size());
  for (const Record& record : records) whole.push_back({record.shot, &record.trace});
  settle_deflections(dataset, whole, seen);
  for (const Record& record : records) {
    MeasuredImpact& shot = seen.shots[record.shot];
    settle_zero(record, shot.noise);
    keep_contact(record, shot);
    if (!shot.has_history())
      seen.missing.push_back(shot.label +
                             ": the noise of the force, stated or as samples before "
                             "contact");
  }
}

}  // namespace rebound
