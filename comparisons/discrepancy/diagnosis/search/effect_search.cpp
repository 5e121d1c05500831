#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"
#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"
#include "comparisons/discrepancy/diagnosis/search/record_after_contact.hpp"

namespace rebound {

EffectNames names_of(const std::vector<EffectChoice>& effects) {
  EffectNames names;
  for (const auto& effect : effects) names.insert(effect.name);
  return names;
}

bool EffectSearch::singles() {
  around_.look_for_starts();
  const Ranked ranked = best_of_each_kind(ranking(around_, base().chi_square));
  const std::vector<std::string> forms = free_forms(base().effects, false);
  const auto starts_of = [&](std::size_t i) {
    if (i < ranked.size()) return around_.starts(ranked[i].first, starts_per_effect);
    const EffectCard& card = find_effect(forms[i - ranked.size()]).card;
    if (card.contains.empty()) return starts_of_free_form(card, seen_, base());
    return starts_of_a_pair(card, seen_, around_);
  };
  Fits fits = fit_all(ranked.size() + forms.size(), [&](std::size_t i) {
    return fit_extended(seen_, base(), starts_of(i), SearchEffort::first_look, within());
  });
  finish(fits);
  return found(fits);
}

/// How far the χ² of a fit would fall with one effect more: to first order along the effect, or at
/// the best point of its grid.
EffectSearch::Ranked EffectSearch::ranking(const EffectSensitivities& around, double chi_square) {
  Ranked ranked;
  for (const EffectScore& score : around.scores())
    ranked.emplace_back(
        score.name, std::max(score.gain_chi_square, chi_square - around.best_probe(score.name)));
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return ranked;
}

/// Faults of the measurement are many: they must not take all places from what is physical.
EffectSearch::Ranked EffectSearch::best_of_each_kind(const Ranked& ranked) const {
  Ranked best;
  int physical = 0, faults = 0;
  for (const auto& one : ranked) {
    int& count = is_measurement(one.first) ? faults : physical;
    const int most = is_measurement(one.first) ? rules_.fitted_faults : rules_.fitted_singles;
    if (count++ < most) best.push_back(one);
  }
  return best;
}

/// Fits that are independent of each other; effects that cannot act here, or whose impacts end
/// nowhere, drop out.
EffectSearch::Fits EffectSearch::fit_all(
    std::size_t count, const std::function<HypothesisFit(std::size_t)>& fit) const {
  return fit_each<HypothesisFit>(count, control_, fit);
}

void EffectSearch::finish(Fits& looked_at) const {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& fit : looked_at)
    if (fit) best = std::min(best, fit->chi_square);
  for (const AssessedFit& one : selection_.tried) best = std::min(best, one.fit.chi_square);
  std::vector<std::size_t> promising;
  for (std::size_t i = 0; i < looked_at.size(); ++i)
    if (looked_at[i] && !looked_at[i]->search.converged &&
        looked_at[i]->chi_square <= first_look_reach * best)
      promising.push_back(i);
  Fits finished = fit_all(promising.size(), [&](std::size_t i) {
    return fit_further(seen_, *looked_at[promising[i]], within());
  });
  for (std::size_t i = 0; i < promising.size(); ++i)
    if (finished[i]) looked_at[promising[i]] = std::move(finished[i]);
}

bool EffectSearch::found(const Fits& fits) {
  for (const auto& fit : fits) {
    const double against = fit ? chi_square_against_faults(seen_, *fit) : 0.0;
    if (!fit || !std::isfinite(against)) continue;
    selection_.tried.push_back(judge_by_chi_square(seen_, *fit, rules_));
    HypothesisFit& kept = selection_.tried.back().fit;
    kept.information_criterion += against;
    kept.penalty_of_refits += against;
  }
  std::stable_sort(selection_.tried.begin(), selection_.tried.end(),
                   [](const AssessedFit& a, const AssessedFit& b) {
                     return a.fit.information_criterion < b.fit.information_criterion;
                   });
  judge_candidates(selection_.tried, rules_.close_criterion, [&](AssessedFit& one) { judge(one); });
  selection_.indistinguishable = indistinguishable_models(selection_.tried, rules_.close_criterion);
  keep_history_beside_slow_memory();
  return is_settled();
}

bool EffectSearch::is_settled() const {
  const auto& candidates = selection_.indistinguishable;
  const bool single = std::any_of(candidates.begin(), candidates.end(), [&](std::size_t i) {
    return added(selection_.tried[i].fit) == 1;
  });
  return may_end_with(selection_.tried, candidates, base().effects.size()) &&
         !(single && leader_over_adequate(selection_.tried, rules_.close_criterion,
                                          rules_.smallest_adequate_p));
}

void EffectSearch::judge(AssessedFit& one) const {
  judge_candidate(seen_, effects_, rules_, seed_, selection_.baseline, one);
}

void EffectSearch::keep_history_beside_slow_memory() {
  auto& members = selection_.indistinguishable;
  const std::size_t known = base().effects.size();
  if (members.empty() || !std::all_of(members.begin(), members.end(), [&](std::size_t i) {
        return is_slow_memory_alone(seen_, selection_.tried[i].fit, known);
      }))
    return;
  for (std::size_t i = 0; i < selection_.tried.size(); ++i) {
    AssessedFit& one = selection_.tried[i];
    if (added(one.fit) != 1 ||
        find_effect(one.fit.effects.back().name).card.family != EffectFamily::history)
      continue;
    if (!one.judged) judge(one);
    if (!one.adequate) continue;
    members.push_back(i);
    return;
  }
}

}  // namespace rebound
