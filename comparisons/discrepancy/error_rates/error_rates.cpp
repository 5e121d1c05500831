#include "comparisons/discrepancy/error_rates/error_rates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/discrepancy/error_rates/stored_trials.hpp"
#include "comparisons/discrepancy/trials/trial_rates.hpp"
#include "comparisons/discrepancy/trials/trial_table.hpp"

namespace rebound {
namespace {

constexpr int few_speeds = 3;

std::vector<TrialRecord> read_stored_trials() {
  std::vector<TrialRecord> records;
  for (const StoredTrials& table : stored_trials())
    for (TrialRecord& record :
         trial_table_of(std::string(table.text), std::string(table.name)).records)
      records.push_back(std::move(record));
  return records;
}

bool shows(const TrialTruth& truth) {
  return !truth.effects.empty() && truth.visible_chi_square >= smallest_visible_chi_square;
}

const char* true_where(const std::string& verdict) {
  if (verdict == "agrees") return "no effect shows";
  if (verdict == "missing") return "the effect that is named was hidden, or all that are named";
  if (verdict == "family") return "the hidden effect is of that family";
  if (verdict == "one-of") return "the hidden effect is one of the set";
  if (verdict == "measurement-fault") return "a fault of the measurement was hidden";
  return "something was hidden";
}

/// Of several names all must be true.
bool all_named_are_hidden(const TrialAnswer& said, const TrialTruth& truth) {
  if (said.candidates.empty()) return false;
  const std::vector<std::string>& names = said.candidates.front();
  return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::any_of(truth.effects.begin(), truth.effects.end(),
                       [&](const TrialEffect& one) { return one.registry_name == name; });
  });
}

bool is_true(const TrialAnswer& said, const TrialTruth& truth) {
  if (said.verdict == "agrees") return !shows(truth);
  const auto any_of_them = [&](const auto& holds) {
    return std::any_of(truth.effects.begin(), truth.effects.end(), holds);
  };
  if (said.verdict == "missing") return all_named_are_hidden(said, truth);
  if (said.verdict == "family")
    return any_of_them([&](const TrialEffect& one) { return said.family == one.family; });
  if (said.verdict == "one-of")
    return any_of_them(
        [&](const TrialEffect& one) { return in_a_candidate(said, one.registry_name); });
  if (said.verdict == "measurement-fault")
    return any_of_them([](const TrialEffect& one) { return one.family == "measurement"; });
  return !truth.effects.empty();
}

/// The noise of the trials that is nearest to this one, by their ratio.
double nearest_noise(double share, const std::vector<TrialRecord>& trials) {
  double nearest = 0.0, farthest = std::numeric_limits<double>::infinity();
  for (const TrialRecord& one : trials) {
    if (!one.truth.ball.empty() || !(one.truth.noise_share > 0.0)) continue;
    const double away = std::abs(std::log(one.truth.noise_share / share));
    if (away >= farthest) continue;
    farthest = away;
    nearest = one.truth.noise_share;
  }
  return nearest;
}

void count(const TrialRecord& trial, const std::string& verdict, ErrorRates& rates) {
  const TrialAnswer& said = trial.outcome.said;
  const int speeds = trial.outcome.speeds;
  rates.fewest_speeds = rates.trials == 0 ? speeds : std::min(rates.fewest_speeds, speeds);
  rates.most_speeds = std::max(rates.most_speeds, speeds);
  ++rates.trials;
  if (trial.truth.effects.empty() && !is_missing(said)) rates.false_alarm.add(says_gap(said));
  if (shows(trial.truth)) rates.effect_seen.add(says_gap(said));
  if (said.verdict == verdict) rates.verdict_true.add(is_true(said, trial.truth));
}

}  // namespace

std::vector<ErrorRates> error_rates_of(const MeasuredDesign& design, const std::string& verdict,
                                       const std::vector<TrialRecord>& trials) {
  if (!(design.noise_share > 0.0)) return {};
  const double noise = nearest_noise(design.noise_share, trials);
  const bool few = design.speeds <= few_speeds;
  ErrorRates of_points{.noise_share = noise, .true_means = true_where(verdict)};
  ErrorRates in_fem{.in_fem = true, .true_means = true_where(verdict)};
  for (const TrialRecord& trial : trials) {
    if (trial.truth.believed != "lumped") continue;
    if (!trial.truth.ball.empty())
      count(trial, verdict, in_fem);
    else if (trial.truth.noise_share == noise && (trial.outcome.speeds <= few_speeds) == few)
      count(trial, verdict, of_points);
  }
  std::vector<ErrorRates> rates;
  for (const ErrorRates& one : {of_points, in_fem})
    if (one.trials > 0) rates.push_back(one);
  return rates;
}

std::vector<ErrorRates> error_rates_of(const MeasuredDesign& design, const std::string& verdict) {
  static const std::vector<TrialRecord> kept = read_stored_trials();
  return error_rates_of(design, verdict, kept);
}

}  // namespace rebound
