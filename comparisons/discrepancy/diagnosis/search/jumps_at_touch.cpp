#include "comparisons/discrepancy/diagnosis/search/jumps_at_touch.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// What an effect of about this size brings, the fit's own unknowns moved to first order.
double gain_near(const EffectSensitivities& around, EffectChoice effect, const Range& range) {
  double most = 0.0;
  const double size = effect.size;
  for (const double factor : {1.0, 2.0, 4.0}) {
    effect.size = std::clamp(factor * size, range.lowest, range.highest);
    most = std::max(most, -around.rise(effect).value_or(0.0));
  }
  return most;
}

}  // namespace

double gain_of_jumps(const Observations& seen, const HypothesisFit& fit,
                     const EffectSensitivities& around, double limit) {
  constexpr double worth_a_fit = 0.2;  // of the limit
  std::vector<EffectChoice> starts;
  for (const EffectSensitivity& tried : around.all()) {
    const EffectCard& card = find_effect(tried.effect.name).card;
    if (!card.jumps_at_touch) continue;
    const EffectScore score = around.score_of(tried);
    starts.push_back(tried.effect);
    starts.back().size =
        std::clamp(std::max(score.size, score.size_error), card.range.lowest, card.range.highest);
  }
  around.run_impacts();
  std::vector<double> gains(starts.size(), 0.0);
  in_parallel(starts.size(), [&](std::size_t i) {
    const EffectCard& card = find_effect(starts[i].name).card;
    gains[i] = gain_near(around, starts[i], card.range);
    if (gains[i] < worth_a_fit * limit) return;
    try {
      gains[i] =
          fit.chi_square - fit_extended(seen, fit, {starts[i]}, SearchEffort::whole).chi_square;
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
      gains[i] = 0.0;
    }
  });
  return std::accumulate(gains.begin(), gains.end(), 0.0,
                         [](double most, double gain) { return std::max(most, gain); });
}

}  // namespace rebound
