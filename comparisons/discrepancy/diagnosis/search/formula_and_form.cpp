// Pairs that hold a free form: the third part of EffectSearch.
#include <algorithm>

#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

namespace rebound {
namespace {

/// With another beside it, a form of thirteen numbers bends to anything.
bool is_free_form_of_few(const EffectChoice& effect) {
  const EffectCard& card = find_effect(effect.name).card;
  return card.is_free_form && !card.after_single_effects;
}

/// Is there a form that contains both?
bool are_parts_of_one_form(const EffectChoice& one, const EffectChoice& other) {
  return std::any_of(all_effects().begin(), all_effects().end(), [&](const Effect& effect) {
    const auto from_part = effect.card.from_part;
    return from_part && from_part(one) && from_part(other);
  });
}

}  // namespace

bool EffectSearch::sets_of_a_formula_and_a_form() {
  const HypothesisFit* pair = best_pair_of_formulas();
  if (!pair) return is_settled();
  const EffectChoice &last = pair->effects.back(), &first = pair->effects[base().effects.size()];
  std::vector<FormBeside> all = forms_beside(first, last);
  for (FormBeside& one : forms_beside(last, first)) all.push_back(std::move(one));
  return found_pair(all);
}

bool EffectSearch::sets_of_two_forms() {
  std::vector<FormBeside> all;
  std::set<EffectNames> extended, known;
  for (const AssessedFit& one : selection_.tried) {
    const EffectNames own = names_of(one.fit.effects);
    if (added(one.fit) != 1 || !is_free_form_of_few(one.fit.effects.back()) ||
        !extended.insert(own).second)
      continue;
    for (FormBeside& form : of_other_families(one.fit, free_forms(base().effects, false))) {
      EffectNames both = own;
      both.insert(form.starts.front().name);
      if (known.insert(both).second) all.push_back(std::move(form));
    }
    if (extended.size() == most_forms_extended) break;
  }
  return found_pair(all);
}

/// Where nothing is adequate, a pair that is nearly so and leads plainly is the candidate.
bool EffectSearch::found_pair(const std::vector<FormBeside>& all) {
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
  std::vector<std::string> forms = free_forms(base().effects, false);
  for (std::string& name : free_forms(base().effects, true)) forms.push_back(std::move(name));
  for (const std::string& name : forms) {
    if (find_effect(name).card.contains != formula.name) continue;
    EffectNames freed = names_of(base().effects);
    freed.insert(name);
    if (const HypothesisFit* fit = fit_of(freed)) all.push_back({fit, {other}});
  }
  if (const HypothesisFit* alone = fit_of(known))
    for (FormBeside& one : of_other_families(*alone, forms)) all.push_back(std::move(one));
  return all;
}

/// Those of `forms` that may stand beside the one effect of a fit; not the two whose sum is a form
/// of its own, as loading and unloading.
std::vector<EffectSearch::FormBeside> EffectSearch::of_other_families(
    const HypothesisFit& fit, const std::vector<std::string>& forms) const {
  std::vector<FormBeside> all;
  const EffectChoice& own = fit.effects.back();
  const EffectCard& card_of_own = find_effect(own.name).card;
  for (const std::string& name : forms) {
    const EffectCard& card = find_effect(name).card;
    EffectNames alone = names_of(base().effects), both = names_of(fit.effects);
    alone.insert(name);
    both.insert(name);
    const HypothesisFit* single = fit_of(alone);
    if (card.family == card_of_own.family || !card.contains.empty() ||
        are_hidden_mass_and_curve(card_of_own, card) ||
        (single && are_parts_of_one_form(own, single->effects.back())) || is_tried(both))
      continue;
    all.push_back({&fit, starts_of_free_form(card, seen_, fit)});
  }
  return all;
}

}  // namespace rebound
