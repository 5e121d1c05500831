#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"
#include "comparisons/discrepancy/diagnosis/search/unseen_choice.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"

namespace rebound {
namespace {

/// A shot that contradicts its own repeats is a fault of that shot.
void suspect_shot(Diagnosis& d, const MeasuredImpact& shot) {
  suspect_measurement(d, {{"odd-shot"}},
                      fmt::format("odd-shot (shot {}, {}), which contradicts its own repeats",
                                  shot.number, shot.label));
  d.excluded.clear();
}

/// Is a cell of the map off by more than noise alone makes of any? Its limit is that of the largest
/// of all cells: noise passes it once in fifty data sets, and by a fifth, if it is normal, at most
/// once in some five hundred.
bool is_plain_in_a_cell(const ResidualMap& map) {
  constexpr double above_threshold = 1.2;
  return map.largest > above_threshold * map.threshold;
}

/// Does a candidate gain more than effects gain where nothing is hidden? χ² of two thousand
/// readings may pass where a single number would bring fifty.
bool gains_more_than_noise_gives(const Diagnosis& d) {
  constexpr double most = 20.0;  // in χ² + 2 k: of 200 nulls the best effect gained 15 at most
  const double before = d.selection.baseline.fit.prediction_criterion;
  const auto& candidates = d.selection.indistinguishable;
  return std::any_of(candidates.begin(), candidates.end(), [&](std::size_t i) {
    return before - d.selection.tried[i].fit.prediction_criterion > most;
  });
}

/// A gap that noise could make, of which several effects each explain a little and none at the
/// unseen speed: the believed model stands. Of two thousand readings χ² says nothing of what fifty
/// of them have; the cells of the map say that.
bool is_no_gap_worth_having(const Diagnosis& d, const SelectionRules& rules, double noise) {
  return d.verdict == DiagnosisVerdict::one_of && d.family == EffectFamily::none &&
         d.believed.p_value > rules.smallest_adequate_p && !is_plain_in_a_cell(d.believed.map) &&
         !gains_more_than_noise_gives(d) && *d.gap.held_out_before - 1.0 <= noise &&
         *d.gap.held_out_after >= *d.gap.held_out_before;
}

/// Beside FE's own part, χ² of the believed model is that of its errors, and the unseen speed shows
/// no gap. What its cells and effects still find is as large as what a mesh gets wrong: its errors
/// are of no noise, and known to a factor.
bool is_within_errors_of_fem(const Diagnosis& d, const SelectionRules& rules, double noise) {
  constexpr double settled = 0.01;  // of the peak force: FE that errs by more tells nothing apart
  // In χ²: of 137 balls of FE with nothing hidden the best single effect gained 55 at most.
  constexpr double found_in_errors = 60.0;
  const double gained = d.selection.baseline.fit.chi_square - d.best().chi_square;
  return d.model_discrepancy != nullptr && d.model_discrepancy->numerical_uncertainty <= settled &&
         gained <= found_in_errors && d.believed.p_value > rules.smallest_adequate_p &&
         *d.gap.held_out_before - 1.0 <= noise;
}

void let_the_believed_model_stand(Diagnosis& d) {
  d.withheld = fmt::format(
      "{} of {} candidates explains a little that noise could do as well, and at the unseen speed "
      "the gap goes from {:.3g} to {:.3g}",
      fmt::join(d.candidates.front(), " + "), d.candidates.size(), *d.gap.held_out_before,
      *d.gap.held_out_after);
  drop_candidates(d);
  d.verdict = DiagnosisVerdict::agrees;
  d.family = EffectFamily::none;
  d.fault.clear();
}

/// Is the candidate that comes nearest a fault that all shots share? It would be there at the
/// unseen speed, too; one of a single shot is not.
bool is_shared_fault(const Diagnosis& d) {
  if (d.verdict != DiagnosisVerdict::measurement_fault) return false;
  const std::vector<std::string>& nearest = d.candidates.front();
  return std::none_of(nearest.begin(), nearest.end(), [](const std::string& name) {
    return acts_on_one_shot(find_effect(name).card);
  });
}

/// Does the unseen speed fit worse with a fault that all shots share, beyond what chance does?
bool speaks_against_a_shared_fault(const Diagnosis& d, const SelectionRules& rules) {
  return is_shared_fault(d) && d.unseen_before && d.unseen_after &&
         d.unseen_after->chi_square - d.unseen_before->chi_square > rules.close_criterion;
}

/// Is there no gap at the unseen speed, and one with what was found? Of a thousand trials of laws
/// with a family or a name this is so in one, whose family is wrong.
bool opens_a_gap(const Diagnosis& d, const SelectionRules& rules, double noise) {
  return *d.gap.held_out_before - 1.0 <= noise && *d.gap.held_out_after - 1.0 > noise &&
         d.unseen_before && d.unseen_after &&
         d.unseen_after->chi_square - d.unseen_before->chi_square > rules.close_criterion;
}

}  // namespace

bool is_of_two_families(const Diagnosis& d) {
  const std::vector<EffectChoice>& effects = d.best().effects;
  const std::size_t known = d.selection.baseline.fit.effects.size();
  if (d.candidates.size() != 1 || effects.size() != known + 2) return false;
  const EffectFamily first = acting_family(*d.seen, d.best(), known),
                     second = acting_family(*d.seen, d.best(), known + 1);
  return first != second && first != EffectFamily::measurement &&
         second != EffectFamily::measurement;
}

DiagnosisVerdict without_name(const Diagnosis& d) {
  return d.family != EffectFamily::none || is_of_two_families(d) ? DiagnosisVerdict::family
                                                                 : DiagnosisVerdict::unexplained;
}

void drop_candidates(Diagnosis& d) {
  d.candidates.clear();
  d.effects.clear();
  d.curves.clear();
  d.next.clear();
  d.bootstrap = {};
  d.selection.indistinguishable.clear();
  d.unseen_after.reset();
  d.gap.after.reset();
  d.gap.held_out_after.reset();
}

void withhold(Diagnosis& d, DiagnosisVerdict weaker, const std::string& why) {
  d.verdict = weaker;
  d.withheld = why;
  if (weaker == DiagnosisVerdict::unexplained) d.family = EffectFamily::none;
  d.effects.clear();
  d.fault.clear();
  // The repair of a formula that contradicts its own restitution stands by itself.
  const HypothesisFit& baseline = d.selection.baseline.fit;
  for (std::size_t k = d.believed_effects; k < baseline.effects.size(); ++k)
    d.effects.push_back(named_effect(baseline, k));
}

void withhold_what_the_unseen_speed_denies(Diagnosis& d, const SelectionRules& rules) {
  if (d.verdict == DiagnosisVerdict::agrees && d.gap.held_out_before) {
    if (const auto odd = odd_one_of(d.unseen_before->of_shots))
      suspect_shot(d, d.unseen->shots[*odd]);
    else if (is_plain_gap(*d.gap.held_out_before, d.gap.held_out_noise))
      withhold(
          d, DiagnosisVerdict::unexplained,
          fmt::format("the believed model agrees with what was fitted, but at the unseen speed "
                      "the gap is {:.3g}: the shots contradict each other, or something acts "
                      "at that speed alone",
                      *d.gap.held_out_before));
    return;
  }
  const bool names = d.verdict == DiagnosisVerdict::missing ||
                     d.verdict == DiagnosisVerdict::one_of ||
                     d.verdict == DiagnosisVerdict::family || is_shared_fault(d);
  if (!names || !d.gap.held_out_before || !d.gap.held_out_after) return;
  if (d.selection.indistinguishable.empty()) return;  // the repair of a formula alone
  constexpr double deviations = 3.0, worth_having = 0.5;
  const double noise = deviations * d.gap.held_out_noise;
  if (is_no_gap_worth_having(d, rules, noise) || is_within_errors_of_fem(d, rules, noise))
    return let_the_believed_model_stand(d);
  const double excess = *d.gap.held_out_before - 1.0;
  const double removed = *d.gap.held_out_before - std::max(1.0, *d.gap.held_out_after);
  if (excess > noise && removed >= worth_having * excess) return;
  if (speaks_against_a_shared_fault(d, rules))
    return withhold(
        d, DiagnosisVerdict::unexplained,
        fmt::format("a fault of all shots would be there at the unseen speed, and with {} its "
                    "chi-square rises by {:.3g}",
                    label_of(d.best().effects),
                    d.unseen_after->chi_square - d.unseen_before->chi_square));
  if (opens_a_gap(d, rules, noise)) {
    if (d.believed.p_value > rules.smallest_adequate_p && !is_plain_in_a_cell(d.believed.map))
      return let_the_believed_model_stand(d);
    return withhold(d, DiagnosisVerdict::unexplained,
                    fmt::format("the unseen speed has no gap, and with {} one of {:.3g}",
                                label_of(d.best().effects), *d.gap.held_out_after));
  }
  if (excess <= noise || *d.gap.held_out_after - 1.0 <= noise) {
    if (d.verdict == DiagnosisVerdict::missing)
      withhold(
          d, without_name(d),
          fmt::format("at the unseen speed the gap goes from {:.3g} to {:.3g}, so that nothing "
                      "beyond the noise is seen to improve there",
                      *d.gap.held_out_before, *d.gap.held_out_after));
    return;
  }
  withhold(d, DiagnosisVerdict::unexplained,
           fmt::format("{} explains what was fitted, but at the unseen speed the gap goes from "
                       "{:.3g} to {:.3g}",
                       label_of(d.best().effects), *d.gap.held_out_before, *d.gap.held_out_after));
}

void withhold_what_repetition_denies(Diagnosis& d, const SelectionRules& rules) {
  if (d.verdict != DiagnosisVerdict::missing || d.bootstrap.draws == 0) return;
  for (std::size_t k = d.selection.baseline.fit.effects.size(); k < d.best().effects.size(); ++k) {
    const std::string& name = d.best().effects[k].name;
    const double share = d.bootstrap.inclusion(name);
    if (share >= rules.least_inclusion) continue;
    withhold(d, without_name(d),
             fmt::format("{} would be chosen in {:.0f} % of repeated measurements only", name,
                         100.0 * share));
    return;
  }
}

}  // namespace rebound
