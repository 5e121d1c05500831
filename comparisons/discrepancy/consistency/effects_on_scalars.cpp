#include "comparisons/discrepancy/consistency/effects_on_scalars.hpp"

#include <algorithm>
#include <optional>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {
namespace {

constexpr std::size_t looked_at = 8, searched_to_the_end = 4;

/// The effects that promise most, by the first order or by their grid.
std::vector<std::string> promising(const EffectSensitivities& around, double chi_square) {
  std::vector<std::pair<double, std::string>> gains;
  for (const EffectScore& score : around.scores())
    gains.emplace_back(std::max(score.gain_chi_square, chi_square - around.best_probe(score.name)),
                       score.name);
  std::stable_sort(gains.begin(), gains.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(looked_at, gains.size()); ++k)
    names.push_back(gains[k].second);
  return names;
}

using Fits = std::vector<std::optional<HypothesisFit>>;

std::vector<HypothesisFit> best_first(Fits fits) {
  std::vector<HypothesisFit> all;
  for (auto& fit : fits)
    if (fit) all.push_back(std::move(*fit));
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.information_criterion < b.information_criterion;
  });
  return all;
}

/// The best of first looks, and those within reach of it, searched to their ends.
Fits searched_further(const Observations& seen, std::vector<HypothesisFit> looks,
                      const RunControl& within) {
  if (looks.empty()) return {};
  const auto search_on = [&](std::size_t k) { return fit_further(seen, looks[k], within); };
  Fits fits = fit_each<HypothesisFit>(1, within, search_on);
  const double best = fits.front() ? fits.front()->chi_square : looks.front().chi_square;
  std::size_t further = 1;
  while (further < std::min(searched_to_the_end, looks.size()) &&
         looks[further].chi_square < first_look_reach * best)
    ++further;
  for (auto& fit : fit_each<HypothesisFit>(further - 1, within,
                                           [&](std::size_t k) { return search_on(k + 1); }))
    fits.push_back(std::move(fit));
  for (std::size_t k = further; k < looks.size(); ++k) fits.emplace_back(std::move(looks[k]));
  return fits;
}

}  // namespace

std::vector<HypothesisFit> try_effects(const Observations& seen, const HypothesisFit& believed,
                                       const RunControl& control) {
  const RunControl within{.interrupted = control.interrupted};
  EffectSensitivities around(seen, believed, absent_effects(believed.effects), GridDetail::coarse);
  around.look_for_starts();
  const std::vector<std::string> names = promising(around, believed.chi_square);
  std::vector<HypothesisFit> fits =
      best_first(fit_each<HypothesisFit>(names.size(), control, [&](std::size_t k) {
        return fit_extended(seen, believed, around.starts(names[k], 1), SearchEffort::first_look,
                            within);
      }));
  std::vector<HypothesisFit> tried;
  for (HypothesisFit& fit : best_first(searched_further(seen, std::move(fits), within)))
    if (fit.chi_square < believed.chi_square) tried.push_back(std::move(fit));
  return tried;
}

}  // namespace rebound
