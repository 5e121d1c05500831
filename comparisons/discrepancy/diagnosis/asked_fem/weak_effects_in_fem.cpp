#include "comparisons/discrepancy/diagnosis/asked_fem/weak_effects_in_fem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// In χ²: gains of nulls are in the README.
constexpr double worth_a_fit = 25.0, is_seen = 40.0;
constexpr std::size_t most_fits = 4;

/// Where its search starts, and what it would gain to first order.
struct PromisingEffect {
  EffectChoice start;
  double gain = 0.0;
};

std::vector<EffectChoice> all_starts(const Diagnosis& d) {
  const HypothesisFit& lumped = d.selection.baseline.fit;
  std::vector<EffectChoice> starts;
  for (const StartsOfEffects& effects :
       {starts_of_named(lumped), starts_of_free_forms(*d.seen, lumped)})
    for (const std::vector<EffectChoice>& of_one : effects)
      starts.insert(starts.end(), of_one.begin(), of_one.end());
  return starts;
}

/// At the size where it gains most, within what first order can say and the effect may be; nothing
/// where it would have the other sign.
std::optional<EffectChoice> moved_to_its_size(EffectChoice start, double factor) {
  constexpr double least = 0.05, most = 5.0;
  const Range& range = find_effect(start.name).card.range;
  const double sign = factor < 0.0 ? -1.0 : 1.0;
  start.size *= sign * std::clamp(std::abs(factor), least, most);
  return range.contains(start.size) ? std::optional(std::move(start)) : std::nullopt;
}

/// Of every effect the start that promises most, best first; those alone that are worth a fit.
std::vector<PromisingEffect> promising_effects(const Diagnosis& d, const FemOfBalls& balls,
                                               const FemOfAllBalls& without) {
  const std::vector<EffectChoice> starts = all_starts(d);
  const std::vector<FirstOrderGain> gains = balls.first_order_gains(starts, without);
  std::vector<PromisingEffect> promising;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    if (gains[k].chi_square < worth_a_fit) continue;
    const auto start = moved_to_its_size(starts[k], gains[k].factor);
    if (!start) continue;
    const auto known =
        std::find_if(promising.begin(), promising.end(),
                     [&](const PromisingEffect& one) { return one.start.name == start->name; });
    if (known == promising.end())
      promising.push_back({*start, gains[k].chi_square});
    else if (gains[k].chi_square > known->gain)
      *known = {*start, gains[k].chi_square};
  }
  std::stable_sort(promising.begin(), promising.end(),
                   [](const auto& a, const auto& b) { return a.gain > b.gain; });
  if (promising.size() > most_fits) promising.resize(most_fits);
  return promising;
}

}  // namespace

void look_for_weak_effects_in_fem(Diagnosis& d, const Observations& all,
                                  const RunControl& control) try {
  if (!d.held_out_speed) return;  // nothing could deny what is found
  const FemOfBalls balls(d, all, control);
  FemOfAllBalls without = balls.fit({});
  if (!without.follows()) return;
  const std::vector<PromisingEffect> promising = promising_effects(d, balls, without);
  const auto fits = fit_each<FemOfAllBalls>(
      promising.size(), control, [&](std::size_t k) { return balls.fit({promising[k].start}); });
  const auto gains_much = [&](const std::optional<FemOfAllBalls>& with) {
    return with && without.information_criterion() - with->information_criterion() >= is_seen;
  };
  for (const auto& with : fits)
    if (gains_much(with)) without = balls.nearest_without_effects(*with, without);
  for (const auto& with : fits)
    if (gains_much(with)) d.in_fem.push_back(compare_tiers(d, balls, without, *with, 0));
  sort_nearest_first(d.in_fem);
  conclude_from_weak_effects(d, without);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked for weak effects: {}", error.what()));
}

}  // namespace rebound
