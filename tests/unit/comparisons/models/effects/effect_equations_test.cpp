// What survived a wrong sign or a wrong scale in one effect: each against the equation of its card.
#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/simulate.hpp"
#include "lumped/mechanisms/factor_curve.hpp"
#include "tests/support/effect_cases.hpp"

namespace rebound {
namespace {

// One branch of a spectrum alone is the effect of one relaxation time.
TEST(EffectEquationsTest, BranchesOfASpectrumAreSixTimesApart) {
  constexpr double time = 0.5e-3, share = 0.4;
  const auto of = [](const EffectChoice& effect) {
    return simulate_fast(test::elastic_with({effect})).scalars;
  };
  const auto single = of({"relaxation", share, {{"relaxation_time", time}}});
  const auto fast =
      of({"relaxation-spectrum", 0.0, {{"fast_ratio", share}, {"relaxation_time", 6.0 * time}}});
  const auto slow =
      of({"relaxation-spectrum", 0.0, {{"slow_ratio", share}, {"relaxation_time", time / 6.0}}});
  for (const auto& branch : {fast, slow}) {
    EXPECT_NEAR(branch.restitution, single.restitution, 1e-8);
    EXPECT_NEAR(branch.peak_force / single.peak_force, 1.0, 1e-8);
  }
}

TEST(EffectEquationsTest, BranchesOfASpectrumInFem) {
  FemProblem problem = test::fem_problem_for_effects();
  problem.material.branches.clear();
  apply_effects({{"relaxation-spectrum",
                  0.2,
                  {{"fast_ratio", 0.1}, {"slow_ratio", 0.3}, {"relaxation_time", 1e-3}}}},
                problem);
  const auto& branches = problem.material.branches;
  ASSERT_EQ(branches.size(), 3u);
  // Fast, middle, slow: ratios 1 : 2 : 3, times each six times the one before.
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(branches[i].ratio / branches[0].ratio, static_cast<double>(i + 1), 1e-12);
    EXPECT_NEAR(branches[i].relaxation_time, 1e-3 * std::pow(6.0, static_cast<double>(i) - 1.0),
                1e-15);
  }
}

// d at the deflections that the card names is the value that was given there.
TEST(EffectEquationsTest, AddedDampingHasItsPointsAtTheDeflectionsOfItsCard) {
  constexpr double reach = 0.09;
  EffectChoice choice{"damping-curves", 0.0, {{"deflection_reach", reach}}};
  for (int k = 0; k < 6; ++k) choice.parameters["deflection_" + std::to_string(k)] = 0.1 + 0.2 * k;
  const LumpedProblem problem = test::elastic_with({choice});
  const CurveCard& card = find_effect(choice.name).card.curves.front();
  ASSERT_EQ(card.points.size(), 6u);
  for (int k = 0; k < 6; ++k) {
    const double deflection_over_radius = card.points[static_cast<std::size_t>(k)].place * reach;
    EXPECT_NEAR(
        curve_value(problem.model.mechanisms.damping.added, std::pow(deflection_over_radius, 0.25)),
        0.1 + 0.2 * k, 1e-12)
        << k;
  }
}

// A shell of a size above zero is stiffer than the inside, in either tier.
TEST(EffectEquationsTest, AShellIsStifferByItsSize) {
  FemProblem fem = test::fem_problem_for_effects();
  apply_effects({{"layered-core", 0.5, {}}}, fem);
  ASSERT_EQ(fem.material.layers.size(), 1u);
  EXPECT_DOUBLE_EQ(fem.material.layers[0].modulus_factor, 1.5);
  // More of the energy is taken early: the ball is pressed less and leaves sooner.
  const auto plain = simulate_fast(test::elastic_with({{"layered-core", 0.0, {}}})).scalars;
  const auto shell = simulate_fast(test::elastic_with({{"layered-core", 0.5, {}}})).scalars;
  EXPECT_LT(shell.peak_deflection, plain.peak_deflection);
  EXPECT_LT(shell.contact_time, plain.contact_time);
}

// Between the formula (0) and the exact damping (1) the share leads from one to the other.
TEST(EffectEquationsTest, TheShareOfExactDampingLeadsFromTheFormulaToIt) {
  const double stated = *test::problem_for_effects().model.restitution;
  const auto misses = [&](double share) {
    LumpedProblem problem = test::problem_for_effects();
    apply_effects({{"low-loss-damping-formula", share, {}}}, problem);
    return simulate_fast(problem).scalars.restitution - stated;
  };
  const double formula = misses(0.0);
  EXPECT_GT(formula, 0.08);
  EXPECT_NEAR(misses(1.0), 0.0, 1e-6);
  double before = formula;
  for (const double share : {0.1, 0.5, 0.9}) {
    EXPECT_LT(misses(share), before) << share;
    before = misses(share);
  }
  EXPECT_GT(misses(0.1), 0.7 * formula);
}

}  // namespace
}  // namespace rebound
