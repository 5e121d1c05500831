#pragma once

#include <cmath>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound::test {

/// An impact on which every lumped effect shows: deep (x/R about 0.3), not at
/// the reference speed, its damping from a restitution and a low-loss formula.
inline LumpedProblem problem_for_effects() {
  LumpedProblem problem;
  problem.sphere = core_a();
  problem.impact = {.speed = 16.0};
  problem.model.law = "hunt-crossley";
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 2.2e6}};
  problem.model.restitution = 0.6;
  problem.model.damping_formula = "hunt-crossley";
  return problem;
}

/// Hertz's force without any loss of its own.
inline LumpedProblem elastic_with(const std::vector<EffectChoice>& effects) {
  LumpedProblem problem{.sphere = core_a(), .impact = {.speed = 10.0}};
  problem.model.law = "hunt-crossley";
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 3.0e6}, {"damping", 0.0}};
  apply_effects(effects, problem);
  return problem;
}

inline FemProblem fem_problem_for_effects() {
  FemProblem problem;
  problem.sphere = core_a();
  problem.impact = {.speed = 15.0};
  problem.material = {.youngs_modulus = 10e6,
                      .poisson_ratio = 0.4,
                      .branches = {{.ratio = 0.3, .relaxation_time = 0.3e-3}}};
  return problem;
}

/// The size that a card holds for ordinary, at the card's own parameters.
inline EffectChoice at_prior_scale(const Effect& effect) {
  return {.name = effect.card.name, .size = effect.card.prior_scale, .parameters = {}};
}

/// A hundredth of that, away from null.
inline EffectChoice slight(const Effect& effect) {
  const EffectCard& card = effect.card;
  const double size = std::isfinite(card.null) ? card.null + 0.01 * (card.prior_scale - card.null)
                                               : 100.0 * card.prior_scale;
  return {.name = card.name, .size = size, .parameters = {}};
}

inline EffectChoice null_of(const Effect& effect) {
  return {.name = effect.card.name, .size = effect.card.null, .parameters = {}};
}

}  // namespace rebound::test
