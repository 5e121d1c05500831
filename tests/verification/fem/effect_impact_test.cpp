// Every effect with an FE form, through a whole impact: it runs, its energy balance closes,
// and force, contact time and restitution move the way its card says.
#include <gtest/gtest.h>

#include "tests/support/effect_cases.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

FemProblem base() {
  FemProblem problem = test::fem_problem_for_effects();
  // The law on which effects that only a flow rule can have begin.
  problem.material.relaxation = Relaxation::multiplicative;
  return problem;
}

const Mesh& effect_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = base().sphere.radius(), .cells = 400});
  return made;
}

FemResult run(const std::vector<EffectChoice>& effects) {
  FemProblem problem = base();
  apply_effects(effects, problem);
  return test::checked_impact(effect_mesh(), problem);
}

void expect_sign(int sign, double change, const std::string& name) {
  if (sign != 0) {
    EXPECT_GT(sign * change, 0.0) << name;
  }
}

TEST(EffectImpact, EveryFormRunsAndMovesAsItsCardSays) {
  const FemResult plain = run({});
  for (const Effect& effect : all_effects()) {
    if (!effect.to_fem) continue;
    SCOPED_TRACE(effect.card.name);
    const FemResult changed = run({test::at_prior_scale(effect)});
    const double force = changed.scalars.peak_force / plain.scalars.peak_force - 1.0;
    const double time = changed.scalars.contact_time / plain.scalars.contact_time - 1.0;
    const double restitution = changed.scalars.restitution - plain.scalars.restitution;
    EXPECT_GT(std::abs(force) + std::abs(time) + std::abs(restitution), 1e-6);
    ASSERT_TRUE(effect.card.moves.has_value()) << "its card does not say what it moves";
    expect_sign(effect.card.moves->peak_force, force, "force");
    expect_sign(effect.card.moves->contact_time, time, "contact time");
    expect_sign(effect.card.moves->restitution, restitution, "restitution");
  }
}

/// A hundredth of the size does less than a tenth of the change.
TEST(EffectImpact, SmallSizesChangeLittle) {
  const FemResult plain = run({});
  for (const char* name : {"strain-stiffening", "foam-softening", "layered-core", "rate-stiffening",
                           "velocity-exponent", "hysteresis", "permanent-set"}) {
    const Effect& effect = find_effect(name);
    const auto change = [&](const EffectChoice& choice) {
      const auto& scalars = run({choice}).scalars;
      return std::abs(scalars.restitution - plain.scalars.restitution) +
             std::abs(scalars.peak_deflection / plain.scalars.peak_deflection - 1.0);
    };
    EXPECT_LT(change(test::slight(effect)), 0.1 * change(test::at_prior_scale(effect))) << name;
  }
}

}  // namespace
}  // namespace rebound
