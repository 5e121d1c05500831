#include "comparisons/discrepancy/diagnosis/assessed_fit.hpp"

#include <algorithm>
#include <iterator>

#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {

namespace {

/// Chance of as large a χ² or a larger one where nothing is missing. Where the noise itself was
/// estimated, its own error counts: χ² over freedom is a ratio of variances then.
double p_value_of(const HypothesisFit& fit, double noise_freedom) {
  if (noise_freedom > 0.0)
    return fisher_chance_above(fit.freedom, noise_freedom, fit.reduced_chi_square());
  return chi_squared_chance_above(fit.freedom, fit.data_chi_square);
}

}  // namespace

std::vector<std::string> absent_from(const HypothesisFit& fit,
                                     const std::vector<std::string>& effects) {
  std::vector<std::string> others;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(others),
               [&](const std::string& name) {
                 return std::none_of(fit.effects.begin(), fit.effects.end(),
                                     [&](const EffectChoice& one) { return one.name == name; });
               });
  return others;
}

void judge_by(const EffectSensitivities& around, const Observations& seen,
              const SelectionRules& rules, std::uint64_t seed, Look look, AssessedFit& candidate) {
  candidate.p_value = p_value_of(candidate.fit, seen.noise_freedom);
  const double level = look == Look::at_all ? rules.false_gap_level : rules.candidate_level;
  candidate.map = residual_map(seen, candidate.fit, around, level, seed);
  candidate.remaining_threshold = around.threshold(level, seed);
  for (const EffectScore& score : around.scores())
    candidate.best_remaining = std::max(candidate.best_remaining, score.gain_chi_square);
  candidate.adequate = candidate.map.quiet() && candidate.p_value > rules.smallest_adequate_p &&
                       candidate.best_remaining <= candidate.remaining_threshold;
}

AssessedFit judge(const Observations& seen, HypothesisFit fit,
                  const std::vector<std::string>& effects, const SelectionRules& rules,
                  std::uint64_t seed, Look look) {
  AssessedFit candidate;
  candidate.fit = std::move(fit);
  candidate.p_value = p_value_of(candidate.fit, seen.noise_freedom);
  // What χ² refuses needs no closer look; the model that is believed gets one, for its map.
  if (look == Look::at_what_may_pass && candidate.p_value <= rules.smallest_adequate_p)
    return candidate;
  const EffectSensitivities around(seen, candidate.fit, absent_from(candidate.fit, effects),
                                   look == Look::at_all ? GridDetail::fine : GridDetail::coarse);
  judge_by(around, seen, rules, seed, look, candidate);
  return candidate;
}

}  // namespace rebound
