// Sets of effects: the second part of EffectSearch.
#include <algorithm>

#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

namespace rebound {
namespace {

/// A free form has many numbers; of all others, those of three and more are not simple.
bool is_simple(const std::string& name) {
  constexpr std::ptrdiff_t most_parameters = 1;
  const auto& parameters = find_effect(name).card.parameters;
  return std::count_if(parameters.begin(), parameters.end(), [](const EffectParameterCard& one) {
           return one.fitted;
         }) <= most_parameters;
}

/// A set holds one fault of the measurement at most, and none of three numbers or more: a burst
/// or a hum beside an effect fits whatever the effect leaves.
bool may_join(const std::string& name, const HypothesisFit& set) {
  const auto fault = [](const EffectChoice& one) { return is_measurement(one.name); };
  const auto bends_with_it = [&](const EffectChoice& one) {
    return are_hidden_mass_and_curve(find_effect(one.name).card, find_effect(name).card);
  };
  if (std::any_of(set.effects.begin(), set.effects.end(), bends_with_it)) return false;
  return !is_measurement(name) ||
         (is_simple(name) && std::none_of(set.effects.begin(), set.effects.end(), fault));
}

/// Of a formula and the free form that contains it, sets grow from the formula: the further numbers
/// of the form would fit what another effect leaves. Beside a curve one effect is looked for: with
/// two the set has more numbers than a name could stand on.
bool may_grow(const HypothesisFit& set, std::size_t added) {
  if (added > 1 && has_curve(set)) return false;
  return std::all_of(set.effects.begin(), set.effects.end(), [](const EffectChoice& one) {
    if (is_measurement(one.name)) return is_simple(one.name);
    return find_effect(one.name).card.contains.empty();
  });
}

bool has_own_sizes(const HypothesisFit& fit) {
  return std::any_of(fit.effects.begin(), fit.effects.end(),
                     [](const EffectChoice& one) { return !one.size_of_balls.empty(); });
}

}  // namespace

bool are_hidden_mass_and_curve(const EffectCard& one, const EffectCard& other) {
  const auto is_hidden_mass = [](const EffectCard& card) {
    return card.oscillator && !card.oscillator->rings_on;
  };
  return (is_hidden_mass(one) && !other.curves.empty()) ||
         (is_hidden_mass(other) && !one.curves.empty());
}

bool EffectSearch::sets_of(std::size_t count) {
  std::vector<std::string> forms;
  if (count == 2) {
    forms = free_forms(base().effects, true);
    for (const std::string& name : free_forms(base().effects, false))
      if (fitted_part_of(find_effect(name).card)) forms.push_back(name);
  }
  return found(fit_extensions(extensions(count), forms));
}

void EffectSearch::sets_beside_curves() {
  const auto& candidates = selection_.indistinguishable;
  if (!std::all_of(candidates.begin(), candidates.end(),
                   [&](std::size_t i) { return has_curve(selection_.tried[i].fit); }))
    return;
  std::vector<Extension> all = extensions(2);
  // Two formulas of one family are but another curve of it.
  std::erase_if(all, [&](const Extension& one) {
    const HypothesisFit& from = selection_.tried[one.from].fit;
    return has_curve(from) ||
           find_effect(one.added).card.family == find_effect(from.effects.back().name).card.family;
  });
  found(fit_extensions(std::move(all), {}));
}

/// The sets that promise most, and free forms of many numbers beside them.
EffectSearch::Fits EffectSearch::fit_extensions(std::vector<Extension> all,
                                                const std::vector<std::string>& forms) const {
  std::stable_sort(all.begin(), all.end(),
                   [](const Extension& a, const Extension& b) { return a.expected < b.expected; });
  if (std::ssize(all) > rules_.fitted_pairs)
    all.resize(static_cast<std::size_t>(rules_.fitted_pairs));
  const std::vector<AssessedFit>& before = selection_.tried;
  Fits fits = fit_all(all.size() + forms.size(), [&](std::size_t i) {
    if (i >= all.size()) return look_at_whole(find_effect(forms[i - all.size()]).card, before);
    return fit_extended(seen_, before[all[i].from].fit, all[i].starts, SearchEffort::first_look,
                        within());
  });
  finish(fits);
  return fits;
}

/// The single mass that two masses in series contain, as fitted; null for other forms.
const HypothesisFit* EffectSearch::fitted_part_of(const EffectCard& card) const {
  if (!card.oscillator_pair) return nullptr;
  for (const AssessedFit& one : selection_.tried)
    if (added(one.fit) == 1 && one.fit.effects.back().name == card.contains) return &one.fit;
  return nullptr;
}

/// A free form of many numbers is looked for from nothing, and from the free forms that it
/// contains; two masses in series from the one that is fitted.
HypothesisFit EffectSearch::look_at_whole(const EffectCard& card,
                                          const std::vector<AssessedFit>& before) const {
  if (const HypothesisFit* part = fitted_part_of(card))
    return fit_extended(seen_, base(),
                        starts_around_a_part(card, part->effects.back(), seen_, around_),
                        SearchEffort::first_look, within());
  HypothesisFit best = fit_extended(seen_, base(), starts_of_free_form(card, seen_, base()),
                                    SearchEffort::first_look, within());
  for (const AssessedFit& one : before) {
    if (!card.from_part || added(one.fit) != 1) continue;
    const auto start = card.from_part(one.fit.effects.back());
    if (!start) continue;
    HypothesisFit part = one.fit;
    part.effects.pop_back();
    HypothesisFit whole = fit_extended(seen_, part, {*start}, SearchEffort::first_look, within());
    if (whole.chi_square < best.chi_square) best = std::move(whole);
  }
  return best;
}

bool EffectSearch::sizes_of_each_ball() {
  const std::vector<HypothesisFit> own = with_own_sizes();
  if (own.empty()) return is_settled();
  return found(
      fit_all(own.size(), [&](std::size_t i) { return fit_further(seen_, own[i], within()); }));
}

/// Of the candidates, or else of the best fits: all formulas with a size of every ball, each from
/// the one that all share. What has been tried so is not tried again.
std::vector<HypothesisFit> EffectSearch::with_own_sizes() const {
  constexpr std::size_t most = 4;
  std::vector<HypothesisFit> own;
  std::set<EffectNames> known;
  for (const AssessedFit& one : selection_.tried)
    if (has_own_sizes(one.fit)) known.insert(names_of(one.fit.effects));
  for (std::size_t i = 0; i < selection_.tried.size() && own.size() < most; ++i) {
    const auto& candidates = selection_.indistinguishable;
    const bool may_stand = candidates.empty() ||
                           std::find(candidates.begin(), candidates.end(), i) != candidates.end();
    const HypothesisFit& shared = selection_.tried[i].fit;
    if (!may_stand || !known.insert(names_of(shared.effects)).second) continue;
    HypothesisFit fit = shared;
    bool varies = false;
    for (std::size_t k = base().effects.size(); k < fit.effects.size(); ++k) {
      EffectChoice& one = fit.effects[k];
      const EffectCard& card = find_effect(one.name).card;
      if (is_measurement(one.name) || card.is_switch || card.is_free_form) continue;
      one.size_of_balls.assign(seen_.balls.size(), one.size);
      varies = true;
    }
    if (varies) own.push_back(std::move(fit));
  }
  return own;
}

bool EffectSearch::prune() {
  bool pruned = false;
  // Without one effect a set may still hold another that it does not need.
  for (std::size_t count = rules_.most_effects; count > 2; --count) {
    const std::vector<Hypothesis> smaller = without_one(count);
    if (smaller.empty()) continue;
    pruned = found(fit_all(smaller.size(), [&](std::size_t i) {
      return fit_hypothesis(seen_, smaller[i], within());
    }));
  }
  return pruned;
}

/// What is left of the sets of `count` effects that stand, each with one taken out; not what has
/// been tried.
std::vector<Hypothesis> EffectSearch::without_one(std::size_t count) const {
  std::vector<Hypothesis> smaller;
  std::set<EffectNames> known;
  for (const std::size_t i : selection_.indistinguishable) {
    const HypothesisFit& fit = selection_.tried[i].fit;
    if (added(fit) != count) continue;
    for (std::size_t k = base().effects.size(); k < fit.effects.size(); ++k) {
      Hypothesis one = fit.hypothesis;
      one.effects = fit.effects;
      one.effects.erase(one.effects.begin() + static_cast<std::ptrdiff_t>(k));
      const EffectNames names = names_of(one.effects);
      if (!is_tried(names) && known.insert(names).second) smaller.push_back(std::move(one));
    }
  }
  return smaller;
}

std::vector<EffectSearch::Extension> EffectSearch::extensions(std::size_t count) const {
  std::vector<Extension> all;
  std::set<EffectNames> known;
  constexpr std::size_t beam = 4;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < selection_.tried.size() && taken < beam; ++i) {
    const HypothesisFit& smaller = selection_.tried[i].fit;
    if (added(smaller) != count - 1 || !may_grow(smaller, count - 1)) continue;
    ++taken;
    const EffectNames own = names_of(smaller.effects);
    // Where to start, the fine grid around the baseline tells; here is but an order.
    const EffectSensitivities near(seen_, smaller, absent_from(smaller.effects, effects_),
                                   GridDetail::coarse);
    for (const auto& [name, gain] : ranking(near, smaller.chi_square)) {
      if (!may_join(name, smaller)) continue;
      EffectNames set = own;
      set.insert(name);
      if (known.insert(set).second)
        all.push_back(
            {i, name, around_.starts(name, starts_per_effect), smaller.chi_square - gain});
    }
  }
  return all;
}

bool EffectSearch::is_tried(const EffectNames& names) const {
  return fit_of(names) != nullptr;
}

}  // namespace rebound
