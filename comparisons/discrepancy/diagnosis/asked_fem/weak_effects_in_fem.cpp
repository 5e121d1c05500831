#include "comparisons/discrepancy/diagnosis/asked_fem/weak_effects_in_fem.hpp"

#include <fmt/format.h>

#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/promising_effects.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// In χ²: gains of nulls are in the README.
constexpr double is_seen = 40.0;

}  // namespace

void look_for_weak_effects_in_fem(Diagnosis& d, const Observations& all,
                                  const RunControl& control) try {
  if (!d.held_out_speed) return;  // nothing could deny what is found
  const FemOfAllBalls nearest = FemOfBalls(d, all, control).fit({});
  if (!nearest.follows()) return;
  const FemOfBalls balls(d, all, nearest.balls, control);
  FemOfAllBalls without = balls.fit({});
  const auto fits = balls.fit_each_alone(promising_effects(
      all_starts(*d.seen, d.selection.baseline.fit), balls.first_order(without), control));
  const auto gains_much = [&](const std::optional<FemOfAllBalls>& with) {
    return with && without.information_criterion() - with->information_criterion() >= is_seen;
  };
  for (const auto& with : fits)
    if (gains_much(with)) without = balls.nearest_without_effects(*with, without);
  // Effects that FE was asked of before were seen against larger errors.
  const std::vector<EffectInFem> asked_before = std::exchange(d.in_fem, {});
  for (const auto& with : fits)
    if (gains_much(with)) d.in_fem.push_back(compare_tiers(d, balls, without, *with, 0));
  sort_nearest_first(d.in_fem);
  conclude_from_weak_effects(d, without);
  deny_where_sharper_cells_do(d, without, balls.unseen(without));
  if (d.verdict != DiagnosisVerdict::agrees) measure_shots(balls, *d.shots_in_fem);
  d.in_fem.insert(d.in_fem.end(), asked_before.begin(), asked_before.end());
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked for weak effects: {}", error.what()));
}

}  // namespace rebound
