#include "comparisons/discrepancy/trials/trial_score.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double visible = 25.0;  // of χ²: below, the data do not hold the effect
constexpr double z = 1.96;        // of 95 %, two sides

double wilson(const Share& share, double sign) {
  if (share.of == 0) return sign > 0.0 ? 1.0 : 0.0;
  const double n = share.of, p = share.value();
  return (p + z * z / (2.0 * n) + sign * z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n))) /
         (1.0 + z * z / n);
}

bool says_gap(const TrialOutcome& o) {
  return o.verdict != "agrees" && o.verdict != "insufficient-data" && o.verdict != "failed";
}

/// The family a verdict stands for; empty where it leaves it open.
std::string family_said(const TrialOutcome& o) {
  return o.verdict == "measurement-fault" ? "measurement" : o.family;
}

bool in_a_candidate(const TrialOutcome& o, const std::string& name) {
  return std::any_of(o.candidates.begin(), o.candidates.end(), [&](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

bool family_in_a_candidate(const TrialOutcome& o, const std::string& family) {
  return std::any_of(o.candidates.begin(), o.candidates.end(), [&](const auto& names) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return name_of(find_effect(name).card.family) == family;
    });
  });
}

void count(Share& share, bool yes) {
  ++share.of;
  if (yes) ++share.count;
}

/// The shares behind the gates.
struct Counts {
  Share false_alarm, family_right, family_right_where_said, wrong_family, name_right, wrong_name;
  Share out_of_family_said, out_of_family_named, unseen_better, coverage, pairs_both,
      pairs_not_false;
};

std::string row_of(const TrialTruth& truth) {
  if (truth.effects.empty()) return "nothing";
  if (truth.effects.size() > 1) return "two effects";
  return truth.effects.front().family;
}

std::string column_of(const TrialOutcome& o) {
  const std::string family = family_said(o);
  if (!says_gap(o) || o.verdict == "unexplained" || family.empty()) return o.verdict;
  return o.verdict == "measurement-fault" ? o.verdict : family;
}

void count_null(const TrialTruth& truth, const TrialOutcome& o, Counts& counts,
                TrialScores& scores) {
  count(counts.false_alarm, says_gap(o));
  count(scores.false_alarms_by_noise[truth.noise_colour + ", stated " + truth.noise_stated],
        says_gap(o));
}

void count_outside(const TrialOutcome& o, Counts& counts) {
  count(counts.out_of_family_said, o.verdict == "unexplained");
  count(counts.out_of_family_named, o.verdict == "missing");
}

void count_single(const TrialEffect& truth, const TrialOutcome& o, Counts& counts,
                  TrialScores& scores) {
  const std::string said = family_said(o);
  const bool open = said.empty();
  const bool in_set = in_a_candidate(o, truth.registry_name);
  count(counts.family_right, said == truth.family);
  if (!open) count(counts.family_right_where_said, said == truth.family);
  count(counts.wrong_family, !open && said != truth.family);
  count(counts.name_right, o.named == truth.registry_name || in_set);
  count(counts.wrong_name, o.verdict == "missing" && o.named != truth.registry_name);
  count(scores.not_wrong_by_form[truth.family + ": " + truth.form],
        said == truth.family || (open && family_in_a_candidate(o, truth.family)));
  if (truth.in_registry && truth.registry_size && o.verdict == "missing" &&
      o.named == truth.registry_name)
    count(counts.coverage,
          o.size_low <= *truth.registry_size && *truth.registry_size <= o.size_high);
}

void count_pair(const TrialTruth& truth, const TrialOutcome& o, Counts& counts) {
  const auto known = [&](const TrialEffect& effect) {
    return in_a_candidate(o, effect.registry_name);
  };
  count(counts.pairs_both, known(truth.effects[0]) && known(truth.effects[1]));
  count(counts.pairs_not_false,
        o.verdict != "missing" || known(truth.effects[0]) || known(truth.effects[1]));
}

void count_unseen(const TrialOutcome& o, Share& better) {
  if (o.verdict != "missing" && o.verdict != "family" && o.verdict != "one-of") return;
  constexpr double deviations = 3.0, gone = 0.8;
  if (!o.held_out_before || !o.held_out_after ||
      *o.held_out_before <= 1.0 + deviations * o.held_out_noise)
    return;
  const double removed = *o.held_out_before - std::max(1.0, *o.held_out_after);
  count(better, removed >= gone * (*o.held_out_before - 1.0));
}

void gather_times(const std::vector<TrialOutcome>& outcomes, TrialScores& scores) {
  std::vector<double> seconds;
  seconds.reserve(outcomes.size());
  for (const TrialOutcome& o : outcomes) seconds.push_back(o.seconds);
  if (seconds.empty()) return;
  std::sort(seconds.begin(), seconds.end());
  scores.median_seconds = seconds[seconds.size() / 2];
  scores.longest_seconds = seconds.back();
}

std::vector<TrialGate> gates_of(const Counts& c) {
  return {
      {.what = "false alarms on nulls",
       .share = c.false_alarm,
       .most = 0.05,
       .most_of_upper_bound = 0.075},
      {.what = "family right", .share = c.family_right, .least = 0.90},
      {.what = "family right, of those that say one", .share = c.family_right_where_said},
      {.what = "wrong family", .share = c.wrong_family, .most = 0.03},
      {.what = "name right or in the set", .share = c.name_right, .least = 0.75},
      {.what = "confidently wrong name", .share = c.wrong_name, .most = 0.03},
      {.what = "outside every family: said so", .share = c.out_of_family_said, .least = 0.80},
      {.what = "outside every family: named", .share = c.out_of_family_named, .most = 0.10},
      {.what = "four fifths of the gap gone at the unseen speed",
       .share = c.unseen_better,
       .least = 0.85},
      {.what = "size within its 95 % interval", .share = c.coverage, .least = 0.90, .most = 0.98},
      {.what = "two effects: both in a candidate", .share = c.pairs_both, .least = 0.75},
      {.what = "two effects: nothing false named", .share = c.pairs_not_false, .least = 0.90}};
}

}  // namespace

double Share::low() const {
  return wilson(*this, -1.0);
}
double Share::high() const {
  return wilson(*this, 1.0);
}

bool TrialGate::passes() const {
  return share.of > 0 && share.value() >= least && share.value() <= most &&
         (most_of_upper_bound >= 1.0 || share.high() <= most_of_upper_bound);
}

TrialScores score_trials(const std::vector<TrialOutcome>& outcomes,
                         const std::vector<TrialTruth>& truths) {
  if (outcomes.size() != truths.size())
    throw Error(ExitCode::corrupt_store, "trials and truths are not as many");
  TrialScores scores{.trials = static_cast<int>(truths.size())};
  Counts counts;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const TrialTruth& truth = truths[i];
    const TrialOutcome& o = outcomes[i];
    if (truth.trial != o.trial)
      throw Error(ExitCode::corrupt_store, "trials and truths are not the same");
    const bool null = truth.effects.empty();
    if (!null && truth.visible_chi_square < visible) continue;
    ++scores.confusion[row_of(truth)][column_of(o)];
    if (null) {
      count_null(truth, o, counts, scores);
      continue;
    }
    if (truth.effects.size() > 1)
      count_pair(truth, o, counts);
    else if (truth.effects.front().family == "out_of_family")
      count_outside(o, counts);
    else
      count_single(truth.effects.front(), o, counts, scores);
    count_unseen(o, counts.unseen_better);
  }
  scores.gates = gates_of(counts);
  gather_times(outcomes, scores);
  return scores;
}

}  // namespace rebound
