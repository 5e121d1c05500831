#include "comparisons/discrepancy/diagnosis/selection.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "comparisons/discrepancy/diagnosis/free_forms.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Names = std::set<std::string>;

Names names_of(const std::vector<EffectChoice>& effects) {
  Names names;
  for (const auto& effect : effects) names.insert(effect.name);
  return names;
}

/// Names with what they promise, best first.
using Ranked = std::vector<std::pair<std::string, double>>;

/// Searches per effect; the best of a grid first.
constexpr std::size_t starts_per_effect = 2;

/// How far the χ² of a fit would fall with one effect more: to first order
/// along the effect, or at the best point of its grid.
Ranked ranking(const EffectSensitivities& around, double chi_square) {
  Ranked ranked;
  for (const EffectScore& score : around.scores())
    ranked.emplace_back(
        score.name, std::max(score.gain_chi_square, chi_square - around.best_probe(score.name)));
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return ranked;
}

/// Fits that are independent of each other; effects that cannot act here, or
/// whose impacts end nowhere, drop out.
std::vector<std::optional<HypothesisFit>> fit_all(
    std::size_t count, const std::function<HypothesisFit(std::size_t)>& fit,
    const RunControl& control) {
  std::vector<std::optional<HypothesisFit>> results(count);
  in_parallel(count, [&](std::size_t i) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted while effects were fitted");
    try {
      results[i] = fit(i);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    }
  });
  return results;
}

void sort_by_criterion(std::vector<AssessedFit>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const AssessedFit& a, const AssessedFit& b) {
                     return a.fit.information_criterion < b.fit.information_criterion;
                   });
}

/// χ² + 2 k. By χ² + k ln N alone, an adequate model of one number would exclude a truth of two:
/// ln N of all samples is more than the reach of a set.
double prediction_criterion(const AssessedFit& one) {
  return one.fit.chi_square + 2.0 * one.fit.effect_unknowns;
}

/// Adequate, within reach of the best adequate one by either criterion, and without a smaller
/// adequate set inside.
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
    const Names own = names_of(tried[i].fit.effects);
    const bool contains_smaller = std::any_of(members.begin(), members.end(), [&](std::size_t j) {
      const Names other = names_of(tried[j].fit.effects);
      return other.size() < own.size() &&
             std::includes(own.begin(), own.end(), other.begin(), other.end());
    });
    if (!contains_smaller) minimal.push_back(i);
  }
  return minimal;
}

/// A set of effects to be fitted: what is fitted already, and one effect more.
struct Extension {
  std::size_t from;  ///< index into the fits tried so far
  std::string added;
  std::vector<EffectChoice> starts;
  double expected;  ///< χ²
};

/// The search for effects, step by step; what it finds stands in `selection`.
class Search {
 public:
  /// `around` is of the baseline; its grid of starts serves all sets.
  Search(const Observations& seen, EffectSensitivities& around,
         const std::vector<std::string>& effects, const SelectionRules& rules, std::uint64_t seed,
         const RunControl& control, EffectSelection& selection)
      : seen_(seen),
        around_(around),
        effects_(effects),
        rules_(rules),
        seed_(seed),
        control_(control),
        selection_(selection) {}

  bool singles() {
    around_.look_for_starts();
    const auto ranked = best_of_each_kind(ranking(around_, base().chi_square));
    return found(fit_all(
        ranked.size(),
        [&](std::size_t i) {
          return fit_extended(seen_, base(), around_.starts(ranked[i].first, starts_per_effect));
        },
        control_));
  }

  /// The families, each without a formula.
  bool families() {
    const std::vector<std::string> forms = free_forms(base().effects);
    return found(fit_all(
        forms.size(),
        [&](std::size_t i) {
          return fit_extended(seen_, base(),
                              starts_of_free_form(find_effect(forms[i]).card, seen_, base()));
        },
        control_));
  }

  /// Sets of `count` effects: the best sets of one less, each with what promises most on its own
  /// residuals.
  bool sets_of(std::size_t count) {
    std::vector<Extension> all = extensions(count);
    std::stable_sort(all.begin(), all.end(), [](const Extension& a, const Extension& b) {
      return a.expected < b.expected;
    });
    if (std::ssize(all) > rules_.fitted_pairs)
      all.resize(static_cast<std::size_t>(rules_.fitted_pairs));
    const std::vector<AssessedFit> before = selection_.tried;
    return found(fit_all(
        all.size(),
        [&](std::size_t i) { return fit_extended(seen_, before[all[i].from].fit, all[i].starts); },
        control_));
  }

  /// Of adequate sets, those with one effect less: a set that needs not all it has is not minimal.
  bool prune() {
    std::vector<Hypothesis> smaller;
    for (const std::size_t i : selection_.indistinguishable) {
      const HypothesisFit& fit = selection_.tried[i].fit;
      if (added(fit) < 3) continue;  // sets of one have been tried
      for (std::size_t k = base().effects.size(); k < fit.effects.size(); ++k) {
        Hypothesis one = fit.hypothesis;
        one.effects = fit.effects;
        one.effects.erase(one.effects.begin() + static_cast<std::ptrdiff_t>(k));
        if (!is_tried(names_of(one.effects))) smaller.push_back(std::move(one));
      }
    }
    return found(fit_all(
        smaller.size(), [&](std::size_t i) { return fit_hypothesis(seen_, smaller[i]); },
        control_));
  }

 private:
  const HypothesisFit& base() const { return selection_.baseline.fit; }
  std::size_t added(const HypothesisFit& fit) const {
    return fit.effects.size() - base().effects.size();
  }
  bool is_tried(const Names& names) const {
    return std::any_of(selection_.tried.begin(), selection_.tried.end(),
                       [&](const auto& one) { return names_of(one.fit.effects) == names; });
  }

  /// Faults of the measurement are many: they must not take all places from what is physical.
  Ranked best_of_each_kind(const Ranked& ranked) const {
    Ranked best;
    int physical = 0, faults = 0;
    for (const auto& one : ranked) {
      int& count = is_measurement(one.first) ? faults : physical;
      const int most = is_measurement(one.first) ? rules_.fitted_faults : rules_.fitted_singles;
      if (count++ < most) best.push_back(one);
    }
    return best;
  }

  /// A set holds one fault of the measurement at most, and none of three numbers or more: a burst
  /// or a hum beside an effect fits whatever the effect leaves.
  bool may_join(const std::string& name, const HypothesisFit& set) const {
    const auto fault = [](const EffectChoice& one) { return is_measurement(one.name); };
    return !is_measurement(name) ||
           (is_simple(name) && std::none_of(set.effects.begin(), set.effects.end(), fault));
  }
  bool may_grow(const HypothesisFit& set) const {
    return std::all_of(set.effects.begin(), set.effects.end(), [](const EffectChoice& one) {
      return !is_measurement(one.name) || is_simple(one.name);
    });
  }
  static bool is_simple(const std::string& name) {
    constexpr std::ptrdiff_t most_parameters = 1;
    const auto& parameters = find_effect(name).card.parameters;
    return std::count_if(parameters.begin(), parameters.end(), [](const EffectParameterCard& one) {
             return one.fitted;
           }) <= most_parameters;
  }

  std::vector<Extension> extensions(std::size_t count) const {
    std::vector<Extension> all;
    std::set<Names> known;
    constexpr std::size_t beam = 4;
    std::size_t taken = 0;
    for (std::size_t i = 0; i < selection_.tried.size() && taken < beam; ++i) {
      const HypothesisFit& smaller = selection_.tried[i].fit;
      if (added(smaller) != count - 1 || !may_grow(smaller)) continue;
      ++taken;
      const Names own = names_of(smaller.effects);
      std::vector<std::string> others;
      for (const auto& name : effects_)
        if (!own.contains(name)) others.push_back(name);
      const EffectSensitivities near(seen_, smaller, others);
      for (const auto& [name, gain] : ranking(near, smaller.chi_square)) {
        if (!may_join(name, smaller)) continue;
        Names set = own;
        set.insert(name);
        if (known.insert(set).second)
          all.push_back(
              {i, name, around_.starts(name, starts_per_effect), smaller.chi_square - gain});
      }
    }
    return all;
  }

  /// Assesses fits; is there an adequate one among all so far?
  bool found(const std::vector<std::optional<HypothesisFit>>& fits) {
    for (const auto& fit : fits)
      if (fit)
        selection_.tried.push_back(
            judge(seen_, *fit, effects_, rules_, seed_, Look::at_what_may_pass));
    sort_by_criterion(selection_.tried);
    selection_.indistinguishable =
        indistinguishable_models(selection_.tried, rules_.close_criterion);
    return !selection_.indistinguishable.empty();
  }

  const Observations& seen_;
  EffectSensitivities& around_;
  const std::vector<std::string>& effects_;
  const SelectionRules& rules_;
  std::uint64_t seed_;
  const RunControl& control_;
  EffectSelection& selection_;
};

}  // namespace

EffectSelection select_effects(const Observations& seen, HypothesisFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control) {
  EffectSelection selection;
  selection.baseline = judge(seen, std::move(baseline), effects, rules, seed);
  EffectSensitivities around(seen, selection.baseline.fit, effects);
  selection.scores = around.scores();
  selection.cosines = around.cosines();
  if (selection.baseline.adequate) {
    selection.excluded = excluded_sizes(around);
    return selection;
  }
  Search search(seen, around, effects, rules, seed, control, selection);
  if (search.singles() || search.families()) return selection;
  for (std::size_t count = 2; count <= rules.most_effects; ++count) {
    const double before = selection.tried.empty() ? 0.0 : selection.tried.front().fit.chi_square;
    if (search.sets_of(count)) {
      search.prune();
      break;
    }
    // A set that gains nothing by one effect more gains nothing by two.
    if (selection.tried.empty() ||
        selection.tried.front().fit.chi_square > before - rules.close_criterion)
      break;
  }
  return selection;
}

}  // namespace rebound
