#include "comparisons/discrepancy/trials/trial_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/trial_controls.hpp"
#include "comparisons/discrepancy/trials/trial_gates.hpp"

namespace rebound {
namespace {

void count_null(const TrialTruth& truth, const TrialAnswer& said, TrialCounts& counts) {
  if (is_missing(said)) return;
  counts.false_alarm.add(says_gap(said));
  if (truth.noise_stated == "half" || truth.noise_stated == "twice")
    counts.false_alarm_misstated.add(says_gap(said));
}

/// Do two effects, or one outside every family, show beside the single effect of a family that is
/// most like them? What a cosine leaves of χ² is 1 − cos².
bool shows_beside_the_nearest(const TrialTruth& truth) {
  return truth.nearest_family &&
         truth.visible_chi_square * (1.0 - std::pow(*truth.nearest_family, 2)) >=
             smallest_visible_chi_square;
}

void count_outside(const TrialTruth& truth, const TrialAnswer& said, TrialCounts& counts) {
  counts.out_of_family_said.add(said.verdict == "unexplained");
  if (shows_beside_the_nearest(truth))
    counts.visibly_out_of_family_said.add(said.verdict == "unexplained");
  counts.out_of_family_named.add(said.verdict == "missing");
}

/// Is nothing else, as far as is known, so like it that nobody could tell the two apart?
bool is_separable(const std::optional<double>& nearest) {
  constexpr double alike = 0.9;  // a fifth of χ² is left between the two
  return nearest && *nearest < alike;
}

/// The same two shares, of those effects that could be told from all others.
void count_separable(const TrialTruth& truth, const TrialAnswer& said, TrialCounts& counts) {
  const TrialEffect& effect = truth.effects.front();
  if (is_separable(truth.nearest_family))
    counts.separable_family_right.add(family_said(said) == effect.family);
  if (is_separable(truth.nearest_name) && !effect.registry_name.empty())
    counts.separable_name_right.add(name_is_said(said, effect.registry_name));
}

void count_single(const TrialEffect& truth, const TrialAnswer& said, TrialCounts& counts) {
  const std::string family = family_said(said);
  counts.detected.add(says_gap(said));
  counts.family_right.add(family == truth.family);
  if (!family.empty()) counts.family_right_where_said.add(family == truth.family);
  counts.wrong_family.add(!family.empty() && family != truth.family);
  counts.abstained.add(family.empty());
  if (!truth.registry_name.empty()) {  // else there is no right one
    const bool right = name_is_said(said, truth.registry_name);
    counts.name_right.add(right);
    counts.formula_right.add(formula_is_said(said, truth.registry_name));
    counts.name_or_nearest.add(right || std::find(said.nearest.begin(), said.nearest.end(),
                                                  truth.registry_name) != said.nearest.end());
  }
  counts.wrong_name.add(said.verdict == "missing" && said.named != truth.registry_name);
  if (said.verdict == "missing") counts.single_name_right.add(said.named == truth.registry_name);
}

void count_pair(const TrialTruth& truth, const TrialAnswer& said, TrialCounts& counts) {
  const bool first = in_a_candidate(said, truth.effects[0].registry_name),
             second = in_a_candidate(said, truth.effects[1].registry_name);
  counts.pairs_both.add(first && second);
  if (shows_beside_the_nearest(truth)) counts.visible_pairs_both.add(first && second);
  counts.pairs_both_families.add(
      are_in_a_candidate(said, truth.effects[0].family, truth.effects[1].family));
  counts.pairs_not_false.add(said.verdict != "missing" || first || second);
}

bool counts_at_all(const TrialTruth& truth) {
  return truth.effects.empty() || truth.visible_chi_square >= smallest_visible_chi_square;
}

void count_answer(const TrialTruth& truth, const TrialAnswer& said, TrialCounts& counts) {
  if (truth.effects.empty())
    count_null(truth, said, counts);
  else if (truth.effects.size() > 1)
    count_pair(truth, said, counts);
  else if (truth.effects.front().family == "out_of_family")
    count_outside(truth, said, counts);
  else {
    count_single(truth.effects.front(), said, counts);
    count_separable(truth, said, counts);
  }
}

/// What the diagnosis alone says: a size, and how the unseen speed is predicted.
void count_size(const TrialTruth& truth, const TrialOutcome& o, Share& coverage) {
  if (truth.effects.size() != 1 || o.said.verdict != "missing") return;
  const TrialEffect& effect = truth.effects.front();
  if (!effect.in_registry || !effect.registry_size || o.said.named != effect.registry_name) return;
  coverage.add(o.size_low <= *effect.registry_size && *effect.registry_size <= o.size_high);
}

void count_unseen(const TrialOutcome& o, Share& better) {
  const std::string& verdict = o.said.verdict;
  if (verdict != "missing" && verdict != "family" && verdict != "one-of") return;
  constexpr double deviations = 3.0, gone = 0.8;
  if (!o.held_out_before || !o.held_out_after ||
      *o.held_out_before <= 1.0 + deviations * o.held_out_noise)
    return;
  const double removed = *o.held_out_before - std::max(1.0, *o.held_out_after);
  better.add(removed >= gone * (*o.held_out_before - 1.0));
}

std::string row_of(const TrialTruth& truth) {
  if (truth.effects.empty()) return "nothing";
  if (truth.effects.size() > 1) return "two effects";
  return truth.effects.front().family;
}

std::string column_of(const TrialAnswer& said) {
  const std::string family = family_said(said);
  if (!says_gap(said) || said.verdict == "unexplained" || family.empty()) return said.verdict;
  return said.verdict == "measurement-fault" ? said.verdict : family;
}

/// The name that is said, or the verdict that says none.
std::string name_or_verdict(const TrialAnswer& said) {
  const bool names = said.verdict == "missing" || said.verdict == "measurement-fault";
  if (!names || said.candidates.empty()) return said.verdict;
  if (!said.named.empty()) return said.named;
  return said.candidates.size() == 1 ? "a set" : said.verdict;
}

void gather_times(const std::vector<TrialRecord>& records, TrialScores& scores) {
  std::vector<double> seconds;
  seconds.reserve(records.size());
  for (const TrialRecord& record : records) seconds.push_back(record.outcome.seconds);
  if (seconds.empty()) return;
  std::sort(seconds.begin(), seconds.end());
  scores.median_seconds = seconds[seconds.size() / 2];
  scores.longest_seconds = seconds.back();
}

using GatesOf = std::vector<TrialGate> (*)(const TrialCounts&);

void gather_controls(const std::vector<TrialRecord>& records, GatesOf gates, TrialScores& scores) {
  for (const ControlName& name : control_names) {
    TrialCounts counts;
    for (const TrialRecord& record : records)
      if (const auto control = record.outcome.controls.find(name.key);
          control != record.outcome.controls.end() && counts_at_all(record.truth))
        count_answer(record.truth, control->second, counts);
    scores.controls[name.key] = gates(counts);
  }
}

/// What is counted beside the gates.
void gather_details(const TrialRecord& record, TrialScores& scores) {
  const TrialTruth& truth = record.truth;
  const TrialAnswer& said = record.outcome.said;
  ++scores.confusion[row_of(truth)][column_of(said)];
  if (is_missing(said)) ++scores.without_answer;
  const bool is_null = truth.effects.empty() && !is_missing(said);
  if (is_null)
    scores.false_alarms_by_noise[truth.noise_colour + ", stated " + truth.noise_stated].add(
        says_gap(said));
  if (is_null && !truth.ball.empty()) scores.false_alarms_by_ball[truth.ball].add(says_gap(said));
  if (truth.effects.size() != 1 || truth.effects.front().family == "out_of_family") return;
  const TrialEffect& effect = truth.effects.front();
  ++scores.confusion_by_name[effect.registry_name.empty()
                                 ? "no such effect in the list"
                                 : effect.registry_name][name_or_verdict(said)];
  const std::string family = family_said(said);
  scores.not_wrong_by_form[effect.family + ": " + effect.form].add(
      family == effect.family || (family.empty() && family_in_a_candidate(said, effect.family)));
}

/// Of balls of one kind.
TrialScores score_alike(const TrialCollection& trials, GatesOf gates) {
  TrialScores scores{.trials = static_cast<int>(trials.records.size()),
                     .protocols = trials.protocols};
  TrialCounts counts;
  int sets = 0, with_candidates = 0;
  for (const TrialRecord& record : trials.records) {
    const TrialTruth& truth = record.truth;
    const TrialOutcome& o = record.outcome;
    ++scores.origins[fmt::format("{}, seed {}", truth.set, truth.seed)];
    if (!counts_at_all(truth)) {
      ++scores.not_visible;
      continue;
    }
    gather_details(record, scores);
    count_answer(truth, o.said, counts);
    count_size(truth, o, counts.coverage);
    if (!truth.effects.empty()) count_unseen(o, counts.unseen_better);
    if (o.said.candidates.empty()) continue;
    sets += static_cast<int>(o.said.candidates.size());
    ++with_candidates;
  }
  if (with_candidates > 0) scores.mean_candidates = static_cast<double>(sets) / with_candidates;
  scores.gates = gates(counts);
  scores.rates = rates_of(trials.records);
  gather_controls(trials.records, gates, scores);
  gather_times(trials.records, scores);
  return scores;
}

}  // namespace

TrialScores score_trials(const TrialCollection& trials) {
  TrialCollection of_points{.records = {}, .protocols = trials.protocols}, in_fem = of_points,
                                                                           fem_believed = of_points;
  for (const TrialRecord& record : trials.records)
    (record.truth.ball.empty()           ? of_points
     : record.truth.believed == "lumped" ? in_fem
                                         : fem_believed)
        .records.push_back(record);
  TrialScores scores = score_alike(of_points, gates_of);
  const auto apart = [](const TrialCollection& some) -> std::shared_ptr<const TrialScores> {
    if (some.records.empty()) return nullptr;
    return std::make_shared<const TrialScores>(score_alike(some, gates_in_fem_of));
  };
  scores.in_fem = apart(in_fem);
  scores.fem_believed = apart(fem_believed);
  return scores;
}

}  // namespace rebound
