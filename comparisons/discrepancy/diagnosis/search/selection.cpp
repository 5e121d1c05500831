#include "comparisons/discrepancy/diagnosis/search/selection.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"
#include "comparisons/discrepancy/diagnosis/search/unseen_choice.hpp"

namespace rebound {
namespace {

/// Sets of two formulas and more; says whether they explain the data.
bool explained_by_formulas(EffectSearch& search, const EffectSelection& selection,
                           const SelectionRules& rules, const std::function<bool(bool)>& ends) {
  for (std::size_t count = 2; count <= rules.most_effects; ++count) {
    const double before = selection.tried.empty() ? 0.0 : selection.tried.front().fit.chi_square;
    if (ends(search.sets_of(count))) {
      search.prune();
      return true;
    }
    // A set that gains nothing by one effect more gains nothing by two.
    if (selection.tried.empty() ||
        selection.tried.front().fit.chi_square > before - rules.close_criterion)
      return false;
  }
  return false;
}

/// The search itself: singles and families, then sets.
void search_effects(EffectSearch& search, const EffectSelection& selection,
                    const SelectionRules& rules) {
  const bool several_balls = selection.baseline.fit.model->balls() > 1;
  const auto ends = [&](bool settled) {
    return several_balls ? search.sizes_of_each_ball() : settled;
  };
  if (ends(search.singles())) {
    search.sets_beside_curves();
    return;
  }
  // Far beyond what sets mend: the believed numbers are not those of this ball, or the data are not
  // of an impact.
  constexpr double hopeless = 1e3;
  if (selection.tried.empty() || selection.tried.front().fit.reduced_chi_square() > hopeless)
    return;
  if (explained_by_formulas(search, selection, rules, ends) ||
      search.sets_of_a_formula_and_a_form())
    return;
  // What FE leaves on a coarse mesh is settled by its own corrections, and not by a curve more.
  if (!selection.baseline.fit.model->fem()) search.sets_of_two_forms();
}

/// Is a gap beyond what noise makes once in fifty data sets, whatever effects there are? Numbers
/// that vary from shot to shot are not asked: a ball that changes and faults of one shot are
/// effects.
bool is_plain(const SelectionRules& rules, const AssessedFit& fit) {
  return fit.p_value <= rules.smallest_adequate_p || fit.leaves_a_force(rules.least_likely_score);
}

/// Is a gap that noise could make once in fifty data sets all there is, and does no effect explain
/// it? A name needs a criterion that is better than that of no effect by as much as one candidate
/// must be better than another; where none has it, what is left over is no evidence of an effect.
bool no_effect_is_worth_it(const Observations& seen, const EffectSensitivities& around,
                           const EffectSelection& selection, const SelectionRules& rules,
                           std::uint64_t seed) {
  const AssessedFit& baseline = selection.baseline;
  const ResidualMap map = residual_map(seen, baseline.fit, around, rules.candidate_level, seed);
  return !is_plain(rules, baseline) &&
         map.largest <= limit_of_estimated_noise(map.threshold, noise_freedom_at(seen, 0.0)) &&
         std::none_of(selection.tried.begin(), selection.tried.end(), [&](const AssessedFit& one) {
           return gain_over(baseline, one) > rules.close_criterion;
         });
}

}  // namespace

EffectSelection select_effects(const Observations& seen, AssessedFit baseline,
                               const std::vector<std::string>& effects, const SelectionRules& rules,
                               std::uint64_t seed, const RunControl& control,
                               const UnseenSpeed& unseen) {
  EffectSelection selection;
  selection.baseline = std::move(baseline);
  const auto looked_at = std::move(selection.baseline.around);
  EffectSensitivities around = looked_at && looked_at->effects() == effects
                                   ? *looked_at
                                   : EffectSensitivities(seen, selection.baseline.fit, effects);
  selection.scores = around.scores();
  selection.cosines = around.cosines();
  std::optional<AssessedFit> in_all;
  if (selection.baseline.adequate && unseen.shots)
    in_all = judge_in_all(*unseen.with_seen, selection.baseline.fit, effects, rules, seed);
  const bool is_seen_with_unseen = in_all && !in_all->adequate;
  // One odd shot among repeats of that speed is no gap of the model.
  if (is_seen_with_unseen)
    selection.baseline.adequate =
        odd_one_of(predict_unseen(*unseen.shots, selection.baseline.fit).of_shots).has_value();
  if (!selection.baseline.adequate) {
    EffectSearch search(seen, around, effects, rules, seed, control, selection);
    search_effects(search, selection, rules);
    const std::size_t known = selection.baseline.fit.effects.size();
    prefer_nearly_adequate(selection.tried, known, rules.close_criterion,
                           selection.indistinguishable);
    deny_other_families_than_leader(selection.tried, known, rules.close_criterion,
                                    rules.smallest_adequate_p, selection.indistinguishable);
    drop_many_numbers_behind_fewer(selection.tried, rules.close_criterion,
                                   rules.smallest_adequate_p, selection.indistinguishable);
    if (unseen.shots && !selection.indistinguishable.empty())
      choose_with_unseen_speed(
          *unseen.shots, rules,
          [&](AssessedFit& one) {
            judge_candidate(seen, effects, rules, seed, selection.baseline, one);
          },
          selection);
    selection.baseline.adequate = !(in_all && is_plain(rules, *in_all)) &&
                                  no_effect_is_worth_it(seen, around, selection, rules, seed);
    drop_what_gains_nothing(selection.tried, selection.baseline, rules.close_criterion,
                            selection.indistinguishable);
  }
  if (selection.baseline.adequate) {
    selection.indistinguishable.clear();
    selection.excluded = excluded_sizes(around);
    if (is_seen_with_unseen)
      selection.faults_of_one_shot =
          faults_of_one_shot(*unseen.with_seen, selection.baseline.fit, rules, seed);
  }
  return selection;
}

}  // namespace rebound
