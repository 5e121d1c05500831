#include "comparisons/discrepancy/diagnosis/selection.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <functional>
#include <set>

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

/// Searches per effect; the best of a grid first.
constexpr std::size_t starts_per_effect = 2;

/// How far the χ² of a fit would fall with one effect more: to first order
/// along the effect, or at the best point of its grid.
std::vector<std::pair<std::string, double>> ranking(const EffectSensitivities& around,
                                                    double chi_square) {
  std::vector<std::pair<std::string, double>> ranked;
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

/// Adequate, within reach of the best adequate one, and without a smaller
/// adequate set inside.
std::vector<std::size_t> indistinguishable_models(const std::vector<AssessedFit>& tried,
                                                  double reach) {
  std::vector<std::size_t> members;
  double best = 0.0;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!tried[i].adequate) continue;
    if (members.empty()) best = tried[i].fit.information_criterion;
    if (tried[i].fit.information_criterion > best + reach) continue;
    members.push_back(i);
  }
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

}  // namespace

AssessedFit judge(const Observations& seen, HypothesisFit fit,
                  const std::vector<std::string>& effects, const SelectionRules& rules,
                  std::uint64_t seed) {
  AssessedFit candidate;
  candidate.fit = std::move(fit);
  std::vector<std::string> others;
  const Names own = names_of(candidate.fit.effects);
  for (const auto& name : effects)
    if (!own.contains(name)) others.push_back(name);
  const EffectSensitivities around(seen, candidate.fit, others);
  candidate.map = residual_map(seen, candidate.fit, around, rules.false_gap_level, seed);
  candidate.remaining_threshold = around.threshold(rules.false_gap_level, seed);
  for (const EffectScore& score : around.scores())
    candidate.best_remaining = std::max(candidate.best_remaining, score.gain_chi_square);
  const boost::math::chi_squared expected(candidate.fit.freedom);
  candidate.p_value =
      boost::math::cdf(boost::math::complement(expected, candidate.fit.data_chi_square));
  candidate.adequate = candidate.map.quiet() && candidate.p_value > rules.smallest_adequate_p &&
                       candidate.best_remaining <= candidate.remaining_threshold;
  return candidate;
}

EffectSelection select_effects(const Observations& seen, HypothesisFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control) {
  EffectSelection selection;
  selection.baseline = judge(seen, std::move(baseline), effects, rules, seed);
  const HypothesisFit& base = selection.baseline.fit;
  EffectSensitivities around(seen, base, effects);
  selection.scores = around.scores();
  selection.cosines = around.cosines();
  if (selection.baseline.adequate) return selection;

  around.look_for_starts();
  auto ranked = ranking(around, base.chi_square);
  if (std::ssize(ranked) > rules.fitted_singles)
    ranked.resize(static_cast<std::size_t>(rules.fitted_singles));
  const auto singles = fit_all(
      ranked.size(),
      [&](std::size_t i) {
        return fit_extended(seen, base, around.starts(ranked[i].first, starts_per_effect));
      },
      control);
  const auto judge_all = [&](const std::vector<std::optional<HypothesisFit>>& fits) {
    for (const auto& fit : fits)
      if (fit) selection.tried.push_back(judge(seen, *fit, effects, rules, seed));
    sort_by_criterion(selection.tried);
  };
  judge_all(singles);
  selection.indistinguishable = indistinguishable_models(selection.tried, rules.close_criterion);
  if (!selection.indistinguishable.empty()) return selection;

  // Pairs: the best singles, each with what promises most on its own residuals.
  struct Pair {
    std::size_t first;
    std::string second;
    std::vector<EffectChoice> starts;
    double expected;  ///< χ²
  };
  std::vector<Pair> pairs;
  constexpr std::size_t beam = 4;
  for (std::size_t i = 0; i < std::min(beam, selection.tried.size()); ++i) {
    const HypothesisFit& single = selection.tried[i].fit;
    std::vector<std::string> others;
    for (const auto& name : effects)
      if (!names_of(single.effects).contains(name)) others.push_back(name);
    EffectSensitivities near(seen, single, others);
    near.look_for_starts();
    for (const auto& [name, gain] : ranking(near, single.chi_square)) {
      const bool known = std::any_of(pairs.begin(), pairs.end(), [&](const Pair& p) {
        return Names{selection.tried[p.first].fit.effects.back().name, p.second} ==
               Names{single.effects.back().name, name};
      });
      if (!known)
        pairs.push_back({i, name, near.starts(name, starts_per_effect), single.chi_square - gain});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.expected < b.expected; });
  if (std::ssize(pairs) > rules.fitted_pairs)
    pairs.resize(static_cast<std::size_t>(rules.fitted_pairs));
  judge_all(fit_all(
      pairs.size(),
      [&](std::size_t i) {
        return fit_extended(seen, selection.tried[pairs[i].first].fit, pairs[i].starts);
      },
      control));
  selection.indistinguishable = indistinguishable_models(selection.tried, rules.close_criterion);
  return selection;
}

}  // namespace rebound
