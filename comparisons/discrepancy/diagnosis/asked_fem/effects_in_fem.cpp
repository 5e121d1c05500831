#include "comparisons/discrepancy/diagnosis/asked_fem/effects_in_fem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "comparisons/discrepancy/diagnosis/asked_fem/effect_fits_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Is the fit that comes nearest one with an effect of the surface?
bool surface_leads(const EffectSelection& selection) {
  return !selection.tried.empty() && act_on_the_surface(selection.tried.front().fit.effects);
}

/// Does the lumped fit that comes nearest hold a fault of the measurement? It acts on the record of
/// a ball of either tier, and keeps both far from the data.
bool fault_leads(const EffectSelection& selection) {
  return !selection.tried.empty() && hold_a_fault(selection.tried.front().fit.effects);
}

/// FE without an effect comes as near as the lumped model does, which beside much noise is the same
/// ball; or the data look like a pull, which keeps a ball of FE without one far from them.
bool is_worth_asking(const Diagnosis& d, const FemOfAllBalls& without) {
  return d.model_discrepancy != nullptr ||
         without.reduced_chi_square() <= d.selection.baseline.fit.reduced_chi_square() ||
         surface_leads(d.selection);
}

bool all_hold(const std::vector<std::vector<std::string>>& candidates,
              const std::function<bool(const std::string&)>& one) {
  return std::all_of(candidates.begin(), candidates.end(), [&](const auto& names) {
    return std::any_of(names.begin(), names.end(), one);
  });
}

/// The fault of the measurement that every candidate holds, with the numbers of the best.
std::optional<EffectChoice> shared_fault(const Diagnosis& d) {
  const std::vector<EffectChoice>& effects = d.best().effects;
  const auto shared = std::find_if(effects.begin(), effects.end(), [&](const EffectChoice& one) {
    return is_measurement(one.name) &&
           all_hold(d.candidates, [&](const std::string& name) { return name == one.name; });
  });
  return shared == effects.end() ? std::nullopt : std::optional(*shared);
}

}  // namespace

bool conclude_from_what_candidates_share(Diagnosis& d, const Observations& all,
                                         const SelectionRules& rules,
                                         const RunControl& control) try {
  const bool is_more_named = std::any_of(d.candidates.begin(), d.candidates.end(),
                                         [](const auto& names) { return names.size() > 1; });
  if (!is_more_named) return false;
  const bool on_plate = d.fem_alone->plate_moves() && all_hold(d.candidates, is_plate);
  const std::optional<EffectChoice> fault = on_plate ? std::nullopt : shared_fault(d);
  if (!on_plate && !fault) return false;
  const FemOfBalls balls(d, all, control);
  EffectFitsInFem tried(d, balls, balls.fit({}), rules, control);
  if (on_plate ? !tried.try_plate_of_fem() : !tried.try_alone(*fault)) {
    d.in_fem.clear();
    return false;
  }
  EffectInFem& shared = d.in_fem.front();
  shared.lumped = "supported";  // with more beside it
  d.fem_with_nothing_hidden =
      Gap{.before = shared.gap.before, .held_out_before = shared.gap.held_out_before};
  conclude_from_fem(d, rules, [&] { return balls.criterion_of_lumped(d.best()); });
  if (on_plate)
    d.withheld = fmt::format(
        "what stands beside it depends on the tier: in FE {} alone takes the gap from {:.3g} to "
        "{:.3g}, and beside a lumped law it needs more",
        shared.effect.name, *shared.gap.before, *shared.gap.after);
  return true;
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(
      fmt::format("FE could not be asked of what the candidates share: {}", error.what()));
  return false;
}

void look_for_effects_in_fem(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                             const RunControl& control) try {
  const FemOfBalls balls(d, all, control);
  const FemOfAllBalls without = balls.fit({});
  const std::optional<double> unseen = balls.unseen(without);
  d.fem_with_nothing_hidden =
      Gap{.before = without.reduced_chi_square(), .held_out_before = unseen};
  const bool is_near = is_worth_asking(d, without);
  if (!is_near && !fault_leads(d.selection)) return;
  if (is_the_noise(without, unseen)) return let_fem_stand(d, without, unseen);
  EffectFitsInFem tried(d, balls, without, rules, control);
  tried.try_all(is_near);
  const std::optional<double> unseen_at_last = balls.unseen(tried.without());
  d.fem_with_nothing_hidden =
      Gap{.before = tried.without().reduced_chi_square(), .held_out_before = unseen_at_last};
  if (!tried.is_any_supported() && is_the_noise(tried.without(), unseen_at_last))
    return let_fem_stand(d, tried.without(), unseen_at_last);
  conclude_from_fem(d, rules, [&] { return balls.criterion_of_lumped(d.best()); });
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked for effects: {}", error.what()));
}

}  // namespace rebound
