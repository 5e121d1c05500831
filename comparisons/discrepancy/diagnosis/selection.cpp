#include "comparisons/discrepancy/diagnosis/selection.hpp"

#include <algorithm>
#include <limits>

#include "comparisons/discrepancy/diagnosis/effect_search.hpp"

namespace rebound {
namespace {

/// χ² + 2 k. By χ² + k ln N alone, an adequate model of one number would exclude a truth of two:
/// ln N of all samples is more than the reach of a set.
double prediction_criterion(const AssessedFit& one) {
  return one.fit.chi_square + 2.0 * one.fit.effect_unknowns;
}

/// Is `general` what `special` is, with a free curve in place of the formulas of its family?
bool frees_formulas_of(const HypothesisFit& general, const HypothesisFit& special) {
  EffectNames formulas = names_of(special.effects);
  for (const EffectChoice& one : general.effects) {
    const EffectCard& free = find_effect(one.name).card;
    if (!free.is_free_form || formulas.contains(one.name)) continue;
    std::erase_if(formulas, [&](const std::string& name) {
      return find_effect(name).card.family == free.family;
    });
  }
  const EffectNames own = names_of(general.effects);
  return formulas.size() < special.effects.size() &&
         std::includes(own.begin(), own.end(), formulas.begin(), formulas.end());
}

}  // namespace

std::vector<std::size_t> indistinguishable_models(const std::vector<AssessedFit>& tried,
                                                  double reach) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double best = none, best_prediction = none;
  for (const AssessedFit& one : tried) {
    if (!one.adequate) continue;
    best = std::min(best, one.fit.information_criterion);
    best_prediction = std::min(best_prediction, prediction_criterion(one));
  }
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i].adequate && (tried[i].fit.information_criterion <= best + reach ||
                              prediction_criterion(tried[i]) <= best_prediction + reach))
      members.push_back(i);
  std::vector<std::size_t> minimal;
  for (const std::size_t i : members) {
    const EffectNames own = names_of(tried[i].fit.effects);
    const bool needs_not_all = std::any_of(members.begin(), members.end(), [&](std::size_t j) {
      const EffectNames other = names_of(tried[j].fit.effects);
      return (other.size() < own.size() &&
              std::includes(own.begin(), own.end(), other.begin(), other.end())) ||
             frees_formulas_of(tried[i].fit, tried[j].fit);
    });
    if (!needs_not_all) minimal.push_back(i);
  }
  return minimal;
}

namespace {

/// The search itself: singles and families, then sets.
void search_effects(EffectSearch& search, const EffectSelection& selection,
                    const SelectionRules& rules) {
  if (search.singles()) return;
  // Far beyond what sets mend: the believed numbers are not those of this ball, or the data are not
  // of an impact.
  constexpr double hopeless = 1e3;
  if (selection.tried.empty() || selection.tried.front().fit.reduced_chi_square() > hopeless)
    return;
  for (std::size_t count = 2; count <= rules.most_effects; ++count) {
    const double before = selection.tried.empty() ? 0.0 : selection.tried.front().fit.chi_square;
    if (search.sets_of(count)) {
      search.prune();
      return;
    }
    // A set that gains nothing by one effect more gains nothing by two.
    if (selection.tried.empty() ||
        selection.tried.front().fit.chi_square > before - rules.close_criterion)
      return;
  }
}

/// Is a gap that noise could make once in fifty data sets all there is, and does no effect explain
/// it? Then the baseline, judged as a candidate is, stands: a name needs a criterion that is better
/// than that of no effect by as much as one candidate must be better than another.
bool no_effect_is_worth_it(const Observations& seen, const EffectSelection& selection,
                           const std::vector<std::string>& effects, const SelectionRules& rules,
                           std::uint64_t seed) {
  const HypothesisFit& baseline = selection.baseline.fit;
  for (const std::size_t i : selection.indistinguishable)
    if (selection.tried[i].fit.information_criterion <
        baseline.information_criterion - rules.close_criterion)
      return false;
  return judge(seen, baseline, effects, rules, seed, Look::at_what_may_pass).adequate;
}

}  // namespace

EffectSelection select_effects(const Observations& seen, HypothesisFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control) {
  EffectSelection selection;
  selection.baseline.fit = std::move(baseline);
  EffectSensitivities around(seen, selection.baseline.fit, effects);
  judge_by(around, seen, rules, seed, Look::at_all, selection.baseline);
  selection.scores = around.scores();
  selection.cosines = around.cosines();
  if (!selection.baseline.adequate) {
    EffectSearch search(seen, around, effects, rules, seed, control, selection);
    search_effects(search, selection, rules);
    selection.baseline.adequate = no_effect_is_worth_it(seen, selection, effects, rules, seed);
  }
  if (selection.baseline.adequate) {
    selection.indistinguishable.clear();
    selection.excluded = excluded_sizes(around);
  }
  return selection;
}

}  // namespace rebound
