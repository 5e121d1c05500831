#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "comparisons/discrepancy/diagnosis/search/jumps_at_touch.hpp"
#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"
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

double largest_z(const ResidualMap& map) {
  double largest = 0.0;
  for (const MapCell& cell : map.cells) largest = std::max(largest, std::abs(cell.z));
  return largest;
}

/// Does one more effect bring no more than what this share of the residuals is in χ²?
bool has_little_remaining(const AssessedFit& baseline, const AssessedFit& candidate, double share) {
  const double explained = baseline.fit.chi_square - candidate.fit.chi_square;
  return candidate.best_remaining <=
         std::max(candidate.remaining_threshold, share * share * explained);
}

/// Is what further numbers would bring no more than what this share of the residuals is in χ²?
bool leaves_little(const ScoreTest& further, const AssessedFit& baseline,
                   const AssessedFit& candidate, double share, double least_chance) {
  const double explained = baseline.fit.chi_square - candidate.fit.chi_square;
  return further.p_value > least_chance || further.excess() <= share * share * explained;
}

/// The same of a force without a formula and of the law's numbers.
bool leaves_little(const AssessedFit& baseline, const AssessedFit& candidate, double share,
                   double least_chance) {
  return leaves_little(candidate.further_force, baseline, candidate, share, least_chance) &&
         leaves_little(candidate.varying, baseline, candidate, share, least_chance);
}

/// Does a candidate leave what showed that something is missing? A score test that few numbers
/// pass by chance shows what χ² does not; a candidate that lowers it a little, until noise could
/// just make the rest, has not found what it shows.
bool leaves_what_showed(const SelectionRules& rules, const ScoreTest& before,
                        const ScoreTest& after) {
  constexpr double most_left = 0.5;  // of the excess
  constexpr double by_chance = 0.1;  // of noise that leaves as much
  return before.p_value <= rules.false_gap_level && after.p_value <= by_chance &&
         after.excess() > most_left * before.excess();
}

/// Of the map, how far above its threshold what is nearly adequate may be.
constexpr double above_threshold = 1.2;

/// A curve through a few points is judged by what it leaves of the residuals of the baseline. What
/// has many numbers and leaves a tenth is not nearly right.
void judge_curve(const SelectionRules& rules, const AssessedFit& baseline, AssessedFit& curve) {
  constexpr double share = 0.1;  // of the residuals
  const double most_remaining = has_many_numbers(curve.fit) ? share : 0.3;
  if (curve.p_value <= rules.smallest_adequate_p) return;
  const double z = largest_z(curve.map), left = share * largest_z(baseline.map);
  const bool beside_another = curve.fit.effects.size() > baseline.fit.effects.size() + 1;
  const double nearly = beside_another ? above_threshold : 1.0;
  const auto is_close = [&](double most) {
    return has_little_remaining(baseline, curve, most) &&
           leaves_little(baseline, curve, most, rules.smallest_adequate_p);
  };
  curve.adequate = z <= std::max(curve.map.threshold, left) && is_close(share);
  curve.nearly_adequate =
      z <= std::max(nearly * curve.map.threshold, left) && is_close(most_remaining);
}

/// A formula that leaves a little is nearly what is missing: of the map a fifth above its
/// threshold, of the χ² a twelfth of what it explains.
void judge_formula(const SelectionRules& rules, const AssessedFit& baseline, AssessedFit& formula) {
  constexpr double most_remaining = 0.3;  // of the residuals
  formula.nearly_adequate =
      formula.p_value > rules.smallest_adequate_p &&
      largest_z(formula.map) <= above_threshold * formula.map.threshold &&
      has_little_remaining(baseline, formula, most_remaining) &&
      leaves_little(baseline, formula, most_remaining, rules.smallest_adequate_p);
}

/// `least_chance` of a force that is not there.
bool leaves_nothing(const SelectionRules& rules, double least_chance, const AssessedFit& fit) {
  return fit.map.quiet() && fit.p_value > rules.smallest_adequate_p &&
         fit.best_remaining <= fit.remaining_threshold && !fit.leaves_a_force(least_chance) &&
         !fit.leaves_varying_numbers(rules.smallest_adequate_p);
}

/// Free forms among the effects beyond the first `known`.
std::ptrdiff_t curves_beyond(const HypothesisFit& fit, std::size_t known) {
  return std::count_if(
      fit.effects.begin() + static_cast<std::ptrdiff_t>(known), fit.effects.end(),
      [](const EffectChoice& one) { return find_effect(one.name).card.is_free_form; });
}

}  // namespace

bool has_many_numbers(const HypothesisFit& fit) {
  return std::any_of(fit.effects.begin(), fit.effects.end(), [](const EffectChoice& one) {
    return find_effect(one.name).card.after_single_effects;
  });
}

bool has_curve(const HypothesisFit& fit) {
  return curves_beyond(fit, 0) > 0;
}

std::vector<std::string> absent_from(const std::vector<EffectChoice>& present,
                                     const std::vector<std::string>& effects) {
  std::vector<std::string> others;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(others),
               [&](const std::string& name) {
                 return std::none_of(present.begin(), present.end(),
                                     [&](const EffectChoice& one) { return one.name == name; });
               });
  return others;
}

std::vector<std::string> absent_effects(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects())
    if (!effect.card.is_free_form && !effect.card.told_by_readings &&
        (effect.to_lumped || effect.to_measurement))
      names.push_back(effect.card.name);
  return absent_from(present, names);
}

AssessedFit judge_by_chi_square(const Observations& seen, HypothesisFit fit,
                                const SelectionRules& rules) {
  AssessedFit candidate;
  candidate.fit = std::move(fit);
  candidate.p_value = p_value_of(candidate.fit, seen.noise_freedom);
  candidate.judged = candidate.p_value <= rules.smallest_adequate_p;
  return candidate;
}

void look_closely(const Observations& seen, const EffectSensitivities& around,
                  const SelectionRules& rules, double level, std::uint64_t seed,
                  double noise_freedom, AssessedFit& fit) {
  const bool estimated = std::isfinite(noise_freedom);
  fit.map = residual_map(seen, fit.fit, around, level, seed);
  if (estimated) fit.map.threshold = limit_of_estimated_noise(fit.map.threshold, noise_freedom);
  fit.remaining_threshold = around.threshold(level, seed);
  for (const EffectScore& score : around.scores())
    fit.best_remaining =
        std::max(fit.best_remaining, estimated ? score.gain_of_known_noise : score.gain_chi_square);
  fit.further_force = test_further_force(seen, fit.fit, around, noise_freedom);
  fit.varying = test_varying_numbers(seen, fit.fit, around, noise_freedom);
  fit.judged = true;
  fit.adequate = leaves_nothing(rules, rules.smallest_adequate_p, fit);
}

void look_at_believed(const Observations& seen, const EffectSensitivities& around,
                      const SelectionRules& rules, std::uint64_t seed, AssessedFit& believed) {
  look_closely(seen, around, rules, rules.false_gap_level, seed, noise_freedom_at(seen, 0.0),
               believed);
  const auto leaves_none = [&] {
    return leaves_nothing(rules, rules.least_likely_score, believed);
  };
  believed.adequate = leaves_none();
  if (!believed.adequate || believed.fit.hypothesis.fem) return;
  believed.best_remaining =
      std::max(believed.best_remaining,
               gain_of_jumps(seen, believed.fit, around, believed.remaining_threshold));
  believed.adequate = leaves_none();
}

AssessedFit judge_believed(const Observations& seen, HypothesisFit fit,
                           const std::vector<std::string>& effects, const SelectionRules& rules,
                           std::uint64_t seed) {
  AssessedFit believed = judge_by_chi_square(seen, std::move(fit), rules);
  believed.around = std::make_shared<const EffectSensitivities>(
      seen, believed.fit, absent_from(believed.fit.effects, effects));
  look_at_believed(seen, *believed.around, rules, seed, believed);
  return believed;
}

void judge_candidate(const Observations& seen, const std::vector<std::string>& effects,
                     const SelectionRules& rules, std::uint64_t seed, const AssessedFit& baseline,
                     AssessedFit& candidate) {
  const EffectSensitivities around(seen, candidate.fit, absent_from(candidate.fit.effects, effects),
                                   GridDetail::coarse);
  look_closely(seen, around, rules, rules.candidate_level, seed, known_noise, candidate);
  if (leaves_what_showed(rules, baseline.further_force, candidate.further_force) ||
      leaves_what_showed(rules, baseline.varying, candidate.varying)) {
    candidate.adequate = false;
    return;
  }
  if (candidate.adequate) return;
  // Two curves bend to nearly anything: they are allowed nothing of what is left.
  if (curves_beyond(candidate.fit, baseline.fit.effects.size()) > 1) return;
  if (has_curve(candidate.fit))
    judge_curve(rules, baseline, candidate);
  else
    judge_formula(rules, baseline, candidate);
}

}  // namespace rebound
