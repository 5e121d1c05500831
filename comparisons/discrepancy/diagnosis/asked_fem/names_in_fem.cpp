#include "comparisons/discrepancy/diagnosis/asked_fem/names_in_fem.hpp"

#include <fmt/format.h>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// From the numbers of the lumped tier, and from a third of the size: an effect means one mechanism
/// in both tiers, and not one number. Of what swings, every strength at the frequency that was
/// found.
std::vector<EffectChoice> starts_of(const EffectChoice& lumped, const Observations& seen) {
  const EffectCard& card = find_effect(lumped.name).card;
  std::vector<EffectChoice> starts;
  if (card.oscillator) {
    for (EffectChoice& one : stronger_effects(*card.oscillator, lumped, seen))
      starts.push_back(std::move(one));
  } else {
    constexpr double third = 1.0 / 3.0;
    starts.push_back(lumped);
    starts.back().size *= third;
  }
  return starts;
}

/// Each effect in turn from all its starts, the others from where they are best so far.
FemOfAllBalls fit_with(const FemOfBalls& balls, std::vector<EffectChoice> effects,
                       const Observations& seen) {
  FemOfAllBalls best = balls.fit(effects);
  for (EffectChoice& effect : effects) {
    EffectChoice nearest = effect;
    for (const EffectChoice& start : starts_of(effect, seen)) {
      effect = start;
      FemOfAllBalls other = balls.fit(effects);
      if (other.chi_square >= best.chi_square) continue;
      best = std::move(other);
      nearest = start;
    }
    effect = nearest;
  }
  return best;
}

std::string tier_verdict(const FemOfAllBalls& without, const FemOfAllBalls& with,
                         const SelectionRules& rules) {
  constexpr double worth_having = 0.5;
  const double gain = without.chi_square - with.chi_square;
  const double excess = without.chi_square - static_cast<double>(without.samples);
  const bool pays =
      without.information_criterion() - with.information_criterion() >= rules.close_criterion;
  if (pays && gain >= worth_having * excess) return "supported";
  return without.follows() ? "rejected" : "no-fit";
}

}  // namespace

bool fem_can_state(const EffectChoice& effect) try {
  if (!find_effect(effect.name).to_fem) return false;
  FemProblem any;
  any.material = {.youngs_modulus = 1e7, .poisson_ratio = 0.3};
  apply_effects({form_in_fem(effect)}, any);
  return true;
} catch (const Error& error) {
  if (error.code() != ExitCode::bad_input) throw;
  return false;
}

void ask_fem_of_names(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                      const RunControl& control) try {
  std::vector<NamedEffect*> asked;
  std::vector<EffectChoice> choices;
  for (NamedEffect& named : d.effects) {
    if (!find_effect(named.effect.name).to_lumped || is_measurement(named.effect.name)) continue;
    if (fem_can_state(named.effect)) {
      asked.push_back(&named);
      choices.push_back(form_in_fem(named.effect));
    } else {
      named.fem = "no-form";
    }
  }
  if (asked.empty()) return;
  const FemOfBalls balls(d, all, control);
  const FemOfAllBalls with = fit_with(balls, choices, *d.seen);
  std::string denied;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    std::vector<EffectChoice> others = choices;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const FemOfAllBalls without = fit_with(balls, others, *d.seen);
    asked[k]->fem = tier_verdict(without, with, rules);
    d.in_fem.push_back(compare_tiers(d, balls, without, with, k));
    d.in_fem.back().lumped = asked[k]->lumped;
    d.in_fem.back().fem = asked[k]->fem;
    if (asked[k]->fem == "rejected" && denied.empty())
      denied = fmt::format(
          "{} depends on the tier: the lumped model needs it, and FE follows the same histories "
          "without it (reduced chi square {:.3g}, and {:.3g} with it)",
          asked[k]->effect.name, without.reduced_chi_square(), with.reduced_chi_square());
  }
  if (denied.empty()) return;
  if (d.verdict == DiagnosisVerdict::missing)
    withhold(d, without_name(d), denied);
  else
    d.warnings.push_back(denied);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked of the name: {}", error.what()));
}

}  // namespace rebound
