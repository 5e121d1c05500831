#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Reduced whitened χ² of the lumped model with these effects beside what its search began with.
std::optional<double> left_by_lumped(const Diagnosis& d, const std::set<std::string>& added) {
  const HypothesisFit& baseline = d.selection.baseline.fit;
  if (added.empty()) return baseline.reduced_chi_square();
  for (const AssessedFit& one : d.selection.tried) {
    std::set<std::string> names;
    for (std::size_t k = baseline.effects.size(); k < one.fit.effects.size(); ++k)
      names.insert(one.fit.effects[k].name);
    if (names == added) return one.fit.reduced_chi_square();
  }
  return std::nullopt;
}

}  // namespace

double FemOfAllBalls::information_criterion() const {
  return chi_square + effect_unknowns * std::log(static_cast<double>(samples));
}

FemOfBalls::FemOfBalls(const Diagnosis& d, const Observations& all, const RunControl& control)
    : d_(d),
      all_(all),
      control_(control),
      near_(d.fem_alone->balls),
      fem_(d.fem_alone->fem),
      // Where FE's part is in the model already, its error is among those of the data.
      seen_(d.model_discrepancy ? *d.seen : with_numerical_uncertainty(*d.seen, *d.fem_alone)),
      unseen_(d.model_discrepancy ? *d.unseen
                                  : with_numerical_uncertainty(*d.unseen, *d.fem_alone)) {}

FemOfBalls::FemOfBalls(const Diagnosis& d, const Observations& all,
                       const std::vector<FittedFem>& balls, const RunControl& control)
    : d_(d), all_(all), control_(control), near_(balls) {
  const TwoMeshes& meshes = *d.fem_alone->meshes;
  const MeshErrors errors =
      compare_meshes(all, balls, meshes, share_missing_beyond(meshes.halvings));
  fem_ = std::make_shared<const FemBelief>(meshes.coarse.with(errors.known));
  const PartedShots shots =
      part_at(all, d.held_out_speed ? choose_held_out(all, d.held_out_speed) : std::nullopt);
  seen_ = with_errors_of_mesh(shots.seen, errors.of_history, errors.of_scalars);
  unseen_ = with_errors_of_mesh(shots.unseen, errors.of_history, errors.of_scalars);
}

FemOfAllBalls FemOfBalls::fit(const std::vector<EffectChoice>& effects) const {
  std::vector<FittedFem> near = near_;
  for (std::size_t ball = 0; ball < near.size(); ++ball)
    near[ball] = with_effects(near[ball], effects_of_ball(effects, ball));
  return fit_near(near);
}

std::vector<std::optional<FemOfAllBalls>> FemOfBalls::fit_each_alone(
    const std::vector<EffectChoice>& effects) const {
  return fit_each<FemOfAllBalls>(effects.size(), control_,
                                 [&](std::size_t k) { return fit({effects[k]}); });
}

FemOfAllBalls FemOfBalls::nearest_without_effects(const FemOfAllBalls& with,
                                                  const FemOfAllBalls& without) const {
  std::vector<FittedFem> near = with.balls;
  for (FittedFem& ball : near) ball.effects.clear();
  FemOfAllBalls again = fit_near(near);
  return again.chi_square < without.chi_square ? again : without;
}

FemOfAllBalls FemOfBalls::fit_near(const std::vector<FittedFem>& near) const {
  FemOfAllBalls whole{.balls = near};
  for (std::size_t ball = 0; ball < all_.balls.size(); ++ball) {
    const auto shots = shots_for_fem(seen_, all_, ball);
    if (shots.empty()) continue;
    FittedFem& own = whole.balls[ball];
    own = fit_fem_model(seen_, shots, d_.selection.baseline.fit, *fem_, near[ball].effects,
                        &near[ball], control_);
    whole.chi_square += own.chi_square;
    whole.samples += own.samples;
    whole.effect_unknowns += own.effect_unknowns;
  }
  return whole;
}

double FemOfBalls::chi_square_with(const std::vector<EffectChoice>& effects,
                                   const FemOfAllBalls& near) const {
  double chi_square = 0.0;
  for (std::size_t ball = 0; ball < all_.balls.size(); ++ball) {
    const auto shots = shots_for_fem(seen_, all_, ball);
    if (shots.empty()) continue;
    const FittedFem with = with_effects(near.balls[ball], effects_of_ball(effects, ball));
    chi_square += chi_square_of(seen_, shots, *fem_, with, control_);
  }
  return chi_square;
}

FirstOrderOfBalls FemOfBalls::first_order(const FemOfAllBalls& at) const {
  std::vector<FirstOrderOfBalls::Ball> balls(all_.balls.size());
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    const auto shots = shots_for_fem(seen_, all_, ball);
    if (shots.empty()) continue;
    balls[ball] = {.fitted = at.balls[ball],
                   .around = std::make_unique<FirstOrderInFem>(
                       seen_, shots, d_.selection.baseline.fit, *fem_, at.balls[ball])};
  }
  return FirstOrderOfBalls(std::move(balls));
}

std::optional<double> FemOfBalls::unseen(const FemOfAllBalls& fitted) const {
  const double samples = unseen_samples();
  if (samples == 0.0) return std::nullopt;
  double chi_square = 0.0;
  for (std::size_t ball = 0; ball < all_.balls.size(); ++ball)
    if (const auto shots = shots_for_fem(unseen_, all_, ball); !shots.empty())
      chi_square += chi_square_of(unseen_, shots, *fem_, fitted.balls[ball], control_);
  return chi_square / samples;
}

double FemOfBalls::unseen_samples() const {
  return samples_looked_at(unseen_);
}

double FemOfBalls::samples_looked_at(const Observations& shots_of) const {
  double samples = 0.0;
  for (std::size_t ball = 0; ball < all_.balls.size(); ++ball)
    for (const std::size_t shot : shots_for_fem(shots_of, all_, ball))
      samples += static_cast<double>(shots_of.shots[shot].trace.force.size());
  return samples;
}

double FemOfBalls::chi_square_looked_at(const Observations& shots_of,
                                        const std::vector<ShotGap>& gaps) const {
  double chi_square = 0.0;
  for (std::size_t ball = 0; ball < all_.balls.size(); ++ball) {
    const ShotGap of_ball = together(gaps, shots_for_fem(shots_of, all_, ball));
    chi_square += of_ball.rows * of_ball.reduced_chi_square;
  }
  return chi_square;
}

double FemOfBalls::criterion_of_lumped(const HypothesisFit& fit) const {
  const HypothesisFit refitted = fit_further(seen_, fit, control_);
  double criterion = chi_square_looked_at(seen_, gaps_of_shots(refitted)) +
                     refitted.effect_unknowns * std::log(samples_looked_at(seen_));
  if (unseen_samples() > 0.0)
    criterion += chi_square_looked_at(unseen_, predict_unseen(unseen_, refitted).of_shots);
  return criterion;
}

std::vector<ShotGap> FemOfBalls::gaps_of_seen(const std::vector<FittedFem>& balls) const {
  return gaps_of(seen_, balls);
}

std::vector<ShotGap> FemOfBalls::gaps_of_unseen(const std::vector<FittedFem>& balls) const {
  return gaps_of(unseen_, balls);
}

std::vector<ShotGap> FemOfBalls::gaps_of(const Observations& shots_of,
                                         const std::vector<FittedFem>& balls) const {
  std::vector<ShotGap> gaps(balls.empty() ? 0 : shots_of.shots.size());
  for (std::size_t ball = 0; ball < balls.size(); ++ball)
    for (const std::size_t shot : shots_for_fem(shots_of, all_, ball)) {
      const std::size_t rows = shots_of.shots[shot].trace.force.size();
      gaps[shot] = {
          .rows = static_cast<int>(rows),
          .reduced_chi_square = chi_square_of(shots_of, {shot}, *fem_, balls[ball], control_) /
                                static_cast<double>(rows)};
    }
  return gaps;
}

void measure_shots(const FemOfBalls& balls, ShotsInFem& shots) {
  shots.before = balls.gaps_of_seen(shots.without);
  shots.after = balls.gaps_of_seen(shots.with);
  shots.unseen_before = balls.gaps_of_unseen(shots.without);
  shots.unseen_after = balls.gaps_of_unseen(shots.with);
}

void measure_shots_in_fem(Diagnosis& d, const Observations& all, const RunControl& control) try {
  if (d.shots_in_fem->before.empty()) measure_shots(FemOfBalls(d, all, control), *d.shots_in_fem);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.shots_in_fem.reset();
}

EffectInFem compare_tiers(const Diagnosis& d, const FemOfBalls& balls, const FemOfAllBalls& without,
                          const FemOfAllBalls& with, std::size_t k) {
  const auto ball = std::find_if(with.balls.begin(), with.balls.end(),
                                 [](const FittedFem& one) { return !one.effects.empty(); });
  const std::vector<EffectChoice>& effects = ball->effects;
  EffectInFem one{.effect = effects[k],
                  .information_criterion = with.information_criterion(),
                  .gap = {.before = without.reduced_chi_square(),
                          .after = with.reduced_chi_square(),
                          .held_out_before = balls.unseen(without),
                          .held_out_after = balls.unseen(with)}};
  one.unseen_chi_square = one.gap.held_out_after.value_or(0.0) * balls.unseen_samples();
  one.without = without.balls;
  one.with = with.balls;
  one.family = find_effect(one.effect.name).card.family;
  std::set<std::string> names;
  for (const EffectChoice& effect : effects) names.insert(effect.name);
  one.lumped_after = left_by_lumped(d, names);
  names.erase(one.effect.name);
  one.lumped_before = left_by_lumped(d, names);
  return one;
}

}  // namespace rebound
