#include "comparisons/discrepancy/diagnosis/observations/prepare_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "comparisons/discrepancy/diagnosis/observations/prepared_record.hpp"
#include "comparisons/discrepancy/diagnosis/observations/settle_deflections.hpp"
#include "comparisons/discrepancy/diagnosis/observations/settle_noise.hpp"
#include "comparisons/discrepancy/diagnosis/observations/whole_impact.hpp"
#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"

namespace rebound {
namespace {

// A contact; fewer where shots are many: a shape takes a hundred, and noise is averaged with it.
constexpr std::size_t most_samples = 600, fewest_samples = 150, most_samples_in_all = 6000;

/// A quarter of a contact after the contact the quiet begins, and it counts for two contacts: what
/// a fault of the measurement does there is no matter of extrapolation far beyond the record's own.
SampleRange quiet_after(const PreparedRecord& record) {
  const std::size_t contact = record.contact.count();
  const std::size_t first = record.contact.last + 1 + contact / 4;
  return {first, std::min(first + 2 * contact, record.trace.time.size()) - 1};
}

/// Leaves the contact with some of the quiet before and after it, and the rest of the quiet after
/// it apart; no history where nothing tells the noise.
void keep_contact(const PreparedRecord& record, MeasuredImpact& shot) {
  if (!(shot.noise.deviation > 0.0)) return;
  const SampleRange kept =
      widened(record.contact, record.contact.count() / 10, record.trace.time.size());
  const auto part = [](const std::vector<double>& column, const SampleRange& range) {
    const auto begin = column.begin();
    return std::vector<double>(begin + static_cast<std::ptrdiff_t>(range.first),
                               begin + static_cast<std::ptrdiff_t>(range.last) + 1);
  };
  shot.trace.time = part(record.trace.time, kept);
  shot.trace.force = part(record.trace.force, kept);
  if (shot.deflection_noise.deviation > 0.0)
    shot.trace.deflection = part(record.trace.deflection, kept);
  const SampleRange after = quiet_after(record);
  if (after.first >= record.trace.time.size()) return;
  shot.after_contact.time = part(record.trace.time, after);
  shot.after_contact.force = part(record.trace.force, after);
}

void take_out_offset(const std::string& name, std::size_t first, Observations& seen) {
  const double level = take_out_zero_offset(std::span(seen.shots).subspan(first));
  if (level == 0.0) return;
  seen.zero_offset = level;
  seen.warnings.push_back(
      fmt::format("{}: the force reads up to {:.3g} N before and after contact, which is taken out "
                  "of every shot",
                  name, level));
}

}  // namespace

void prepare_histories(const Dataset& dataset, std::size_t first, Observations& seen) {
  take_out_offset(dataset.name, first, seen);
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
  std::vector<PreparedRecord> records;
  records.reserve(histories.size());
  for (std::size_t k = 0; k < histories.size(); ++k)
    records.push_back(prepare_record(histories[k], interval, recorders[k], seen));
  if (coarse)
    settle_coarse_noise(records, seen);
  else
    settle_noise(dataset.name, records, seen);
  std::vector<WholeRecord> whole;
  whole.reserve(records.size());
  for (const PreparedRecord& record : records) whole.push_back({record.shot, &record.trace});
  settle_deflections(dataset, whole, seen);
  for (const PreparedRecord& record : records) {
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
