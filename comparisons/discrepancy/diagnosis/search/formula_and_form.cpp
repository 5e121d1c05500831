// Sets of a formula and a free form: the third part of EffectSearch.
#include <algorithm>

#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

namespace rebound {

bool EffectSearch::sets_of_a_formula_and_a_form() {
  const HypothesisFit* pair = best_pair_of_formulas();
  if (!pair) return is_settled();
  const EffectChoice &last = pair->effects.back(), &first = pair->effects[base().effects.size()];
  std::vector<FormBeside> all = forms_beside(first, last);
  for (FormBeside& one : forms_beside(last, first)) all.push_back(std::move(one));
  Fits fits = fit_all(all.size(), [&](std::size_t i) {
    return fit_extended(seen_, *all[i].near, all[i].starts, SearchEffort::first_look, within());
  });
  finish(fits);
  found(fits);
  auto& members = selection_.indistinguishable;
  if (members.empty())
    return accept_leading_pair(selection_.tried, base().effects.size(), rules_.close_criterion,
                               members);
  drop_curves_behind_a_leader();
  return !members.empty();
}

/// A curve beside a formula bends to more than two effects do: where something fits plainly better,
/// and leaves something, there are more than two.
void EffectSearch::drop_curves_behind_a_leader() {
  if (!leader_over_adequate(selection_.tried, rules_.close_criterion, rules_.smallest_adequate_p))
    return;
  for (AssessedFit& one : selection_.tried)
    if (added(one.fit) == 2 && has_curve(one.fit)) one.adequate = false;
  selection_.indistinguishable = indistinguishable_models(selection_.tried, rules_.close_criterion);
}

/// Of what was tried, the set with these effects; null where there is none.
const HypothesisFit* EffectSearch::fit_of(const EffectNames& names) const {
  const auto at =
      std::find_if(selection_.tried.begin(), selection_.tried.end(),
                   [&](const AssessedFit& one) { return names_of(one.fit.effects) == names; });
  return at == selection_.tried.end() ? nullptr : &at->fit;
}

/// By its criterion, and without a fault of the measurement.
const HypothesisFit* EffectSearch::best_pair_of_formulas() const {
  const auto at =
      std::find_if(selection_.tried.begin(), selection_.tried.end(), [&](const AssessedFit& one) {
        return added(one.fit) == 2 && !has_curve(one.fit) &&
               std::none_of(one.fit.effects.begin(), one.fit.effects.end(),
                            [](const EffectChoice& effect) { return is_measurement(effect.name); });
      });
  return at == selection_.tried.end() ? nullptr : &at->fit;
}

std::vector<EffectSearch::FormBeside> EffectSearch::forms_beside(const EffectChoice& formula,
                                                                 const EffectChoice& other) const {
  std::vector<FormBeside> all;
  EffectNames known = names_of(base().effects);
  known.insert(formula.name);
  const HypothesisFit* alone = fit_of(known);
  std::vector<std::string> forms = free_forms(base().effects, false);
  for (std::string& name : free_forms(base().effects, true)) forms.push_back(std::move(name));
  for (const std::string& name : forms) {
    const EffectCard& card = find_effect(name).card;
    if (card.contains == formula.name) {
      EffectNames freed = names_of(base().effects);
      freed.insert(name);
      if (const HypothesisFit* fit = fit_of(freed)) all.push_back({fit, {other}});
    }
    if (!card.contains.empty() || !alone || card.family == find_effect(formula.name).card.family)
      continue;
    EffectNames both = known;
    both.insert(name);
    if (!is_tried(both)) all.push_back({alone, starts_of_free_form(card, seen_, *alone)});
  }
  return all;
}

}  // namespace rebound
