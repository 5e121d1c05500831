#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

namespace rebound {
namespace {

constexpr double half = 0.5;

/// What the lumped tier says of an effect that it did not find.
std::string not_seen_in_lumped(const EffectInFem& one) {
  const bool has_form = find_effect(one.effect.name).to_lumped || is_measurement(one.effect.name);
  return has_form ? "rejected" : "no-form";
}

/// Share of the excess over the noise that has gone.
double share_gone(double before, double after) {
  return before > 1.0 ? (before - std::max(1.0, after)) / (before - 1.0) : 0.0;
}

/// Has that share gone at the unseen speed, or was there no more than FE's errors?
bool holds_at_the_unseen_speed(const Gap& gap, double share) {
  if (!gap.held_out_before) return true;
  return share_gone(*gap.held_out_before, *gap.held_out_after) >= share ||
         std::max(*gap.held_out_before, *gap.held_out_after) <= left_by_fem;
}

bool takes(const EffectInFem& one, double share) {
  return share_gone(*one.gap.before, *one.gap.after) >= share &&
         holds_at_the_unseen_speed(one.gap, share);
}

bool explains(const EffectInFem& one, const FemOfAllBalls& without, const SelectionRules& rules) {
  return without.information_criterion() - one.information_criterion >= rules.close_criterion &&
         takes(one, half) && *one.gap.after <= left_by_fem;
}

/// By a fair share of what was gained for each reading of the speeds that were fitted?
bool is_followed_better_unseen(const EffectInFem& one, double gain_of_a_reading) {
  constexpr double fair_share = 0.2;
  return one.gap.held_out_before &&
         *one.gap.held_out_before - *one.gap.held_out_after >= fair_share * gain_of_a_reading;
}

/// Those that explain the data within reach of the best; none where the best does not.
std::vector<const EffectInFem*> supported_by_fem(const Diagnosis& d, const SelectionRules& rules) {
  std::vector<const EffectInFem*> candidates;
  for (const EffectInFem& one : d.in_fem)
    if (one.fem == "supported" &&
        one.criterion() <= d.in_fem.front().criterion() + rules.close_criterion)
      candidates.push_back(&one);
  if (candidates.empty() || candidates.front() != &d.in_fem.front()) return {};
  return candidates;
}

/// The best, where it takes nearly all of the gap, and nothing of another family half of it: what
/// is left is more than noise, and of whatever else it is.
std::vector<const EffectInFem*> nearly_all_in_fem(const Diagnosis& d) {
  constexpr double nearly_all = 0.9;
  if (d.in_fem.empty() || !takes(d.in_fem.front(), nearly_all)) return {};
  const EffectInFem& best = d.in_fem.front();
  const bool has_rival = std::any_of(d.in_fem.begin(), d.in_fem.end(), [&](const EffectInFem& one) {
    return one.family != best.family && share_gone(*one.gap.before, *one.gap.after) >= half;
  });
  return has_rival ? std::vector<const EffectInFem*>{} : std::vector{&best};
}

/// Before FE's gap takes its place. Where FE's own part is in the model, the search beside it has
/// kept what the law leaves without it.
void keep_gap_of_the_law(Diagnosis& d) {
  if (!d.law_alone)
    d.law_alone = Gap{.before = d.gap.before, .held_out_before = d.gap.held_out_before};
}

/// The gap is that of FE with nothing hidden, and what is left of it with this effect.
void show_gap_in_fem(Diagnosis& d, const EffectInFem& found) {
  keep_gap_of_the_law(d);
  const double held_out_noise = d.gap.held_out_noise;
  d.gap = found.gap;
  d.gap.held_out_noise = held_out_noise;
  d.shots_in_fem = {.effect = found.effect.name, .without = found.without, .with = found.with};
}

/// Does the law with what it has found explain the data, by other families than this one?
bool law_explains_by_others(const Diagnosis& d, EffectFamily family) {
  const bool explains =
      d.verdict == DiagnosisVerdict::family || d.verdict == DiagnosisVerdict::one_of;
  return explains && std::none_of(d.candidates.begin(), d.candidates.end(), [&](const auto& set) {
           return std::any_of(set.begin(), set.end(), [&](const std::string& name) {
             return find_effect(name).card.family == family;
           });
         });
}

/// Both tiers explain the data, each by another family: the law's stands where it is ahead by more
/// than comes close, and else it is one of both.
void keep_what_the_law_says(Diagnosis& d, const EffectInFem& in_fem, double ahead_of_fem,
                            const SelectionRules& rules) {
  const std::string& name = in_fem.effect.name;
  const std::string both =
      fmt::format("in FE {} takes the gap from {:.3g} to {:.3g}, and beside the law {}", name,
                  *in_fem.gap.before, *in_fem.gap.after, fmt::join(d.candidates.front(), " + "));
  if (ahead_of_fem > rules.close_criterion) {
    d.warnings.push_back(
        fmt::format("{} is ahead of it by {:.0f} in χ² and numbers", both, ahead_of_fem));
    return;
  }
  constexpr EffectFamily of_several = EffectFamily::none;
  d.family = of_several;
  d.candidates.push_back({name});
  withhold(d, DiagnosisVerdict::one_of,
           fmt::format("it depends on the tier: {} explains the data as well", both));
}

}  // namespace

void sort_nearest_first(std::vector<EffectInFem>& in_fem) {
  std::stable_sort(in_fem.begin(), in_fem.end(),
                   [](const auto& a, const auto& b) { return a.criterion() < b.criterion(); });
}

EffectInFem with_verdicts(EffectInFem one, const FemOfAllBalls& without,
                          const SelectionRules& rules) {
  one.lumped = not_seen_in_lumped(one);
  one.fem = explains(one, without, rules)   ? "supported"
            : *one.gap.after <= left_by_fem ? "rejected"
                                            : "no-fit";
  return one;
}

bool is_the_noise(const FemOfAllBalls& without, const std::optional<double>& unseen) {
  constexpr double deviations = 3.0;
  const double most = 1.0 + deviations * std::sqrt(2.0 / static_cast<double>(without.samples));
  return without.reduced_chi_square() <= most && unseen.value_or(0.0) <= left_by_fem;
}

void let_fem_stand(Diagnosis& d, const FemOfAllBalls& without, std::optional<double> unseen) {
  drop_candidates(d);
  keep_gap_of_the_law(d);
  d.verdict = DiagnosisVerdict::agrees;
  d.family = EffectFamily::none;
  d.withheld.clear();
  d.gap.before = without.reduced_chi_square();
  d.gap.held_out_before = unseen;
  auto alone = std::make_shared<ModelDiscrepancy>(*d.fem_alone);
  alone->balls = without.balls;  // that a search for effects may have brought nearer
  d.fem_alone = std::move(alone);
  d.shots_in_fem = {.effect = {}, .without = without.balls};
}

void conclude_from_weak_effects(Diagnosis& d, const FemOfAllBalls& without) {
  if (d.in_fem.empty()) return;
  for (EffectInFem& one : d.in_fem) {
    one.lumped = not_seen_in_lumped(one);
    one.fem = "rejected";
  }
  const EffectInFem& best = d.in_fem.front();
  const double gain = without.information_criterion() - best.information_criterion;
  if (!is_followed_better_unseen(best, gain / static_cast<double>(without.samples))) return;
  constexpr double plainly_less = 0.3;  // of the gain: forms are not those of the data
  bool of_one_family = true;
  for (EffectInFem& one : d.in_fem) {
    const bool gains_less =
        one.information_criterion - best.information_criterion > plainly_less * gain;
    if (gains_less || *one.gap.held_out_after > *one.gap.held_out_before) continue;
    one.fem = "supported";
    d.candidates.push_back({one.effect.name});
    of_one_family = of_one_family && one.family == best.family;
  }
  d.excluded.clear();
  show_gap_in_fem(d, best);
  const std::string better = fmt::format(
      "FE with nothing hidden follows the data{}, and follows them better with {}: by {:.0f} in "
      "χ², "
      "and at the unseen speed from {:.3g} to {:.3g}",
      without.follows() ? "" : " within what its cells may err in a search", best.effect.name, gain,
      *best.gap.held_out_before, *best.gap.held_out_after);
  if (of_one_family && best.family == EffectFamily::measurement)
    return suspect_measurement(d, d.candidates, better);
  d.verdict = of_one_family ? DiagnosisVerdict::family : DiagnosisVerdict::one_of;
  d.family = of_one_family ? best.family : EffectFamily::none;
  d.withheld = better + "; beside a lumped law that is not seen";
}

void deny_where_sharper_cells_do(Diagnosis& d, const FemOfAllBalls& without,
                                 std::optional<double> unseen) {
  constexpr double plain_gap = 2.0;  // FE leaves 1.2 of nulls at most (README)
  const double least = std::min(without.reduced_chi_square(), unseen.value_or(0.0));
  if (d.verdict != DiagnosisVerdict::agrees || least < plain_gap) return;
  keep_gap_of_the_law(d);
  d.gap.before = without.reduced_chi_square();
  d.gap.held_out_before = unseen;
  d.shots_in_fem = {.effect = {}, .without = without.balls};
  d.excluded.clear();
  withhold(d, DiagnosisVerdict::unexplained,
           fmt::format("FE with nothing hidden follows the data within what its cells may err in a "
                       "search, and leaves {:.3g} on cells that are corrected for its own ball, "
                       "{:.3g} at the unseen speed",
                       without.reduced_chi_square(), *unseen));
}

void conclude_from_fem(Diagnosis& d, const SelectionRules& rules,
                       const std::function<double()>& criterion_of_lumped) {
  std::vector<const EffectInFem*> candidates = supported_by_fem(d, rules);
  if (candidates.empty()) candidates = nearly_all_in_fem(d);
  if (candidates.empty()) return;
  const EffectFamily family = candidates.front()->family;
  if (std::any_of(candidates.begin(), candidates.end(),
                  [&](const EffectInFem* one) { return one->family != family; }))
    return;
  if (law_explains_by_others(d, family)) {
    const double ahead_of_fem = candidates.front()->criterion() - criterion_of_lumped();
    if (ahead_of_fem >= -rules.close_criterion)
      return keep_what_the_law_says(d, *candidates.front(), ahead_of_fem, rules);
  }
  drop_candidates(d);
  show_gap_in_fem(d, *candidates.front());
  for (const EffectInFem* one : candidates) d.candidates.push_back({one->effect.name});
  const std::string taken =
      fmt::format("in FE {} takes the gap from {:.3g} to {:.3g}", candidates.front()->effect.name,
                  *candidates.front()->gap.before, *candidates.front()->gap.after);
  if (family == EffectFamily::measurement)
    return suspect_measurement(d, d.candidates,
                               taken + ", and beside a lumped law it does not explain the data");
  d.verdict = DiagnosisVerdict::family;
  d.family = family;
  d.withheld = "it depends on the tier: " + taken + ", and beside a lumped law it has no name";
}

}  // namespace rebound
