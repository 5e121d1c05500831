#include "comparisons/discrepancy/trials/trial_rates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace rebound {
namespace {

/// Where a trial belongs: rows stand in the order of `low`, then of their labels.
struct RateBin {
  std::string label;
  double low = 0.0, high = 0.0;

  bool operator<(const RateBin& other) const {
    return low != other.low ? low < other.low : label < other.label;
  }
};

bool is_single_effect(const TrialTruth& truth) {
  return truth.effects.size() == 1 && truth.effects.front().family != "out_of_family";
}

void count_effect(const TrialEffect& effect, const TrialAnswer& said, RateRow& row) {
  ++row.trials;
  row.detected.add(says_gap(said));
  row.family_right.add(family_said(said) == effect.family);
  if (!effect.registry_name.empty()) row.name_right.add(name_is_said(said, effect.registry_name));
  row.wrong_name.add(said.verdict == "missing" && said.named != effect.registry_name);
}

/// Averages over the effects of a row whose nearest rival is known.
class MeanAtBest {
 public:
  void add(const TrialTruth& truth) {
    if (!truth.nearest_family) return;
    sum_ += chance_of_family_at_best(truth.visible_chi_square, *truth.nearest_family);
    ++count_;
  }
  std::optional<double> value() const {
    return count_ == 0 ? std::nullopt : std::optional(sum_ / count_);
  }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

using BinOf = std::function<RateBin(const TrialRecord&)>;

RateTable rates_by(const std::vector<TrialRecord>& records, RateTable table, double least_visible,
                   const BinOf& bin_of) {
  std::map<RateBin, RateRow> rows;
  std::map<RateBin, MeanAtBest> at_best;
  for (const TrialRecord& record : records) {
    const TrialTruth& truth = record.truth;
    const bool effect = is_single_effect(truth) && truth.visible_chi_square >= least_visible;
    if (!effect && !truth.effects.empty()) continue;
    const RateBin bin = bin_of(record);
    if (bin.label.empty()) continue;
    RateRow& row = rows[bin];
    row.label = bin.label;
    row.low = bin.low;
    row.high = bin.high;
    if (effect) {
      count_effect(truth.effects.front(), record.outcome.said, row);
      at_best[bin].add(truth);
    } else if (!is_missing(record.outcome.said)) {
      row.false_alarm.add(says_gap(record.outcome.said));
    }
  }
  for (auto& [bin, row] : rows) {
    row.family_at_best = at_best[bin].value();
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// A factor of about two and a half a bin; what is not visible in one.
RateBin bin_of_size(const TrialRecord& record) {
  if (record.truth.effects.empty()) return {};  // nothing has no size
  constexpr double edges[] = {
      0.0, smallest_visible_chi_square, 60.0, 150.0, 400.0, 1000.0, 2500.0, 6000.0, 15000.0, 1e5};
  const double size = record.truth.visible_chi_square;
  std::size_t i = 0;
  while (i + 2 < std::size(edges) && size >= edges[i + 1]) ++i;
  const bool last = i + 2 == std::size(edges);
  return {last ? fmt::format("{:g} and more", edges[i])
               : fmt::format("{:g} to {:g}", edges[i], edges[i + 1]),
          edges[i], edges[i + 1]};
}

RateBin bin_of_number(double value, const std::string& label) {
  return {label, value, value};
}

}  // namespace

double chance_of_family_at_best(double visible_chi_square, double cosine) {
  constexpr double ahead = 6.0;  // in χ²
  const double square = visible_chi_square * (1.0 - cosine * cosine);
  if (!(square > 0.0)) return 0.0;
  return 0.5 * std::erfc((ahead - square) / (2.0 * std::sqrt(2.0 * square)));
}

std::vector<RateTable> rates_of(const std::vector<TrialRecord>& records) {
  const double visible = smallest_visible_chi_square;
  std::vector<RateTable> tables;
  tables.push_back(rates_by(records,
                            {.by = "visible_chi_square",
                             .what = "size of the effect as its visible χ²",
                             .unit = "1",
                             .rows = {}},
                            0.0, bin_of_size));
  tables.push_back(rates_by(
      records,
      {.by = "noise_share", .what = "noise over the smallest peak force", .unit = "%", .rows = {}},
      visible, [](const TrialRecord& r) {
        const double percent = 100.0 * r.truth.noise_share;
        return bin_of_number(percent, fmt::format("{:.3g}", percent));
      }));
  tables.push_back(rates_by(
      records, {.by = "noise_colour", .what = "colour of the noise", .unit = "", .rows = {}},
      visible, [](const TrialRecord& r) { return RateBin{r.truth.noise_colour}; }));
  tables.push_back(rates_by(
      records, {.by = "noise_stated", .what = "noise as the data state it", .unit = "", .rows = {}},
      visible, [](const TrialRecord& r) { return RateBin{r.truth.noise_stated}; }));
  tables.push_back(
      rates_by(records, {.by = "speeds", .what = "number of speeds", .unit = "1", .rows = {}},
               visible, [](const TrialRecord& r) {
                 return bin_of_number(r.outcome.speeds, std::to_string(r.outcome.speeds));
               }));
  tables.push_back(
      rates_by(records, {.by = "repeats", .what = "shots at each speed", .unit = "1", .rows = {}},
               visible, [](const TrialRecord& r) {
                 if (r.outcome.speeds == 0) return RateBin{};  // its data could not be read
                 const int repeats = r.outcome.shots / r.outcome.speeds;
                 return bin_of_number(repeats, std::to_string(repeats));
               }));
  return tables;
}

}  // namespace rebound
