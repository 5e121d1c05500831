#include "comparisons/discrepancy/consistency/effects_on_scalars.hpp"

#include <algorithm>
#include <optional>

#include "comparisons/discrepancy/diagnosis/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/effect_sensitivities.hpp"

namespace rebound {
namespace {

constexpr std::size_t looked_at = 10, searched_to_the_end = 4;

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
  const std::size_t further = std::min(searched_to_the_end, fits.size());
  Fits ended = fit_each<HypothesisFit>(
      further, control, [&](std::size_t k) { return fit_further(seen, fits[k], within); });
  for (std::size_t k = further; k < fits.size(); ++k) ended.emplace_back(std::move(fits[k]));
  std::vector<HypothesisFit> ended_first = best_first(std::move(ended)), tried;
  for (HypothesisFit& fit : ended_first)
    if (fit.chi_square < believed.chi_square) tried.push_back(std::move(fit));
  return tried;
}

}  // namespace rebound
