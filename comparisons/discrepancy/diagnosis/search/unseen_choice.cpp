#include "comparisons/discrepancy/diagnosis/search/unseen_choice.hpp"

#include <algorithm>
#include <limits>

#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Nothing where the model has no impact at that speed.
std::optional<HeldOutGap> gap_unseen(const Observations& unseen, const HypothesisFit& fit) {
  try {
    return predict_unseen(unseen, fit);
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    return std::nullopt;
  }
}

using Gaps = std::vector<std::optional<HeldOutGap>>;

Gaps ask(const Observations& unseen, const std::vector<AssessedFit*>& fits) {
  Gaps gaps(fits.size());
  in_parallel(fits.size(), [&](std::size_t k) {
    gaps[k] = gap_unseen(unseen, fits[k]->fit);
    fits[k]->unseen_chi_square =
        gaps[k] ? gaps[k]->chi_square : std::numeric_limits<double>::infinity();
  });
  return gaps;
}

/// Does each leave at the unseen speed what chance leaves once in a thousand?
bool all_leave_a_gap(const Gaps& gaps) {
  constexpr double deviations = 3.0;
  return std::all_of(gaps.begin(), gaps.end(), [&](const std::optional<HeldOutGap>& gap) {
    return !gap || gap->reduced_chi_square - 1.0 > deviations * gap->deviation;
  });
}

/// All other fits whose χ² noise could make, where they are adequate and within reach of the
/// candidates once the unseen speed counts.
void add_what_predicts_better(const Observations& unseen, const SelectionRules& rules,
                              const std::function<void(AssessedFit&)>& judge,
                              EffectSelection& selection) {
  auto& members = selection.indistinguishable;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : members)
    best = std::min(best, selection.tried[i].information_criterion());
  std::vector<std::size_t> others;
  std::vector<AssessedFit*> asked;
  for (std::size_t i = 0; i < selection.tried.size(); ++i) {
    AssessedFit& one = selection.tried[i];
    const bool is_refused = one.judged && !one.adequate;
    if (one.unseen_chi_square || is_refused || one.p_value <= rules.smallest_adequate_p) continue;
    others.push_back(i);
    asked.push_back(&one);
  }
  ask(unseen, asked);
  for (const std::size_t i : others) {
    AssessedFit& one = selection.tried[i];
    if (one.information_criterion() > best + rules.close_criterion) continue;
    if (!one.judged) judge(one);
    if (!one.adequate) continue;
    members.push_back(i);
    best = std::min(best, one.information_criterion());
  }
  members = smallest_of(selection.tried, members);
}

}  // namespace

bool is_plain_gap(double reduced_chi_square, double deviation) {
  constexpr double plain = 0.5, noise_deviations = 6.0;
  return reduced_chi_square - 1.0 > std::max(plain, noise_deviations * deviation);
}

std::optional<std::size_t> odd_one_of(const std::vector<ShotGap>& gaps) {
  std::optional<std::size_t> odd;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!is_plain_gap(gaps[i].reduced_chi_square, gaps[i].deviation())) continue;
    if (odd) return std::nullopt;
    odd = i;
  }
  return gaps.size() > 1 ? odd : std::nullopt;
}

AssessedFit judge_in_all(const Observations& all, const HypothesisFit& fit,
                         const std::vector<std::string>& effects, const SelectionRules& rules,
                         std::uint64_t seed) {
  AssessedFit whole = judge_by_chi_square(all, fit_further(all, fit), rules);
  if (whole.judged) return whole;
  const EffectSensitivities around(all, whole.fit, effects);
  look_at_believed(all, around, rules, seed, whole);
  return whole;
}

std::vector<std::string> faults_of_one_shot(const Observations& all, const HypothesisFit& fit,
                                            const SelectionRules& rules, std::uint64_t seed) {
  std::vector<std::string> faults;
  for (const Effect& effect : all_effects())
    if (acts_on_one_shot(effect.card)) faults.push_back(effect.card.name);
  const HypothesisFit whole = fit_further(all, fit);
  const EffectSensitivities around(all, whole, absent_from(whole.effects, faults));
  const std::vector<EffectScore> scores = around.scores();
  double least = around.threshold(rules.false_gap_level, seed);
  for (const EffectScore& score : scores)
    least = std::max(least, score.gain_of_known_noise - rules.close_criterion);
  std::vector<std::string> seen;
  for (const EffectScore& score : scores)
    if (score.gain_of_known_noise >= least) seen.push_back(score.name);
  return seen;
}

void choose_with_unseen_speed(const Observations& unseen, const SelectionRules& rules,
                              const std::function<void(AssessedFit&)>& judge,
                              EffectSelection& selection) {
  auto& members = selection.indistinguishable;
  const std::vector<std::size_t> before = members;
  std::vector<AssessedFit*> candidates;
  candidates.reserve(members.size());
  for (const std::size_t i : members) candidates.push_back(&selection.tried[i]);
  ask(unseen, {&selection.baseline});
  if (all_leave_a_gap(ask(unseen, candidates)))
    add_what_predicts_better(unseen, rules, judge, selection);
  keep_within_reach(selection.tried, rules.close_criterion, members);
  for (const std::size_t i : before) selection.tried[i].unseen_denies = true;
  for (const std::size_t i : members) selection.tried[i].unseen_denies = false;
}

}  // namespace rebound
