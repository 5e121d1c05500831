#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/discrepancy/consistency/all_scalars.hpp"
#include "comparisons/discrepancy/consistency/effects_on_scalars.hpp"
#include "comparisons/discrepancy/consistency/joint_consistency.hpp"
#include "comparisons/discrepancy/consistency/observable_consistency.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

LumpedModel law(double stiffness, double damping) {
  LumpedModel model;
  model.parameters = {{"exponent", 1.5}, {"stiffness", stiffness}, {"damping", damping}};
  return model;
}

/// Scalars of a law at three speeds, each good to half a per cent, with effects hidden in them.
Observations scalars_of(const LumpedModel& model, const std::vector<EffectChoice>& effects = {}) {
  Observations all;
  all.balls = {{.name = "ball", .sphere = {.mass = 89.6e-3, .diameter = 66.2e-3}}};
  for (const double speed : {5.0, 10.0, 15.0, 25.0}) {
    LumpedProblem problem{.sphere = all.balls[0].sphere, .impact = {.speed = speed}};
    problem.model = model;
    apply_effects(effects, problem);
    const ImpactScalars scalars = simulate_fast(problem).scalars;
    MeasuredImpact shot{.label = std::to_string(speed)};
    shot.sphere = problem.sphere;
    shot.impact = problem.impact;
    for (const ScalarQuantity& one : scalar_quantities) {
      const double value = scalars.*one.modelled;
      shot.*one.measured = {.value = value, .uncertainty = 0.005 * value};
    }
    all.shots.push_back(shot);
  }
  return all;
}

void scale_contact_times(Observations& all, double factor) {
  for (MeasuredImpact& shot : all.shots) *shot.contact_time.value *= factor;
}

TEST(ObservableConsistencyTest, DataOfTheModelAgreeWithOneAnother) {
  const ObservableConsistency found =
      compare_observables(scalars_of(law(3.2e6, 7e4)), {.believed = law(3.5e6, 8e4)});
  EXPECT_LT(found.all.fit.reduced_chi_square(), 0.01);
  ASSERT_EQ(found.without.size(), scalar_quantities.size());
  for (const ConsistencyFit& one : found.without)
    EXPECT_NEAR(one.of(*one.left_out).mean, 1.0, 2e-3) << name_of(*one.left_out);
}

// Every other kind of observable is fitted to it when it takes part, and pays.
TEST(ObservableConsistencyTest, AScaledContactTimeIsTheOneThatIsWrong) {
  Observations all = scalars_of(law(3.2e6, 7e4));
  scale_contact_times(all, 1.2);
  const ObservableConsistency found = compare_observables(all, {.believed = law(3.5e6, 8e4)});
  EXPECT_GT(found.all.fit.reduced_chi_square(), 50.0);
  ASSERT_TRUE(found.best());
  EXPECT_EQ(found.best()->left_out, ObservedQuantity::contact_time);
  EXPECT_LT(found.best()->fit.reduced_chi_square(), 0.01);
  EXPECT_NEAR(found.best()->of(ObservedQuantity::contact_time).mean, 1.2, 2e-3);
  EXPECT_LT(found.best()->of(ObservedQuantity::contact_time).scatter, 2e-3);
}

TEST(ObservableConsistencyTest, AKindThatOneShotDoesNotStateIsLeftOutThere) {
  Observations all = scalars_of(law(3.2e6, 7e4));
  all.shots[1].peak_force = {};
  const ObservableConsistency found = compare_observables(all, {.believed = law(3.5e6, 8e4)});
  const ObservableRatio& ratio = found.all.of(ObservedQuantity::peak_force);
  EXPECT_TRUE(std::isnan(ratio.of_shots[1]));
  EXPECT_NEAR(ratio.of_shots[2], 1.0, 2e-3);
  EXPECT_NEAR(ratio.mean, 1.0, 2e-3);
}

/// Two balls whose contact times are wrong by these factors, each compared by itself.
JointConsistency compared_with(double first, double second) {
  Observations one = scalars_of(law(3.2e6, 7e4)), other = scalars_of(law(4e6, 5e4));
  scale_contact_times(one, first);
  scale_contact_times(other, second);
  const Hypothesis believed{.believed = law(3.5e6, 8e4)};
  const ObservableConsistency of_one = compare_observables(one, believed),
                              of_other = compare_observables(other, believed);
  return compare_jointly({&of_one, &of_other});
}

TEST(JointScalarsTest, OneFactorOnAllContactTimesMendsThem) {
  const JointConsistency found = compared_with(1.2, 1.2);
  EXPECT_GT(found.all.reduced_chi_square, 50.0);
  ASSERT_TRUE(found.best());
  EXPECT_EQ(found.best()->left_out, ObservedQuantity::contact_time);
  const JointRatio& ratio = *found.best()->of(ObservedQuantity::contact_time);
  EXPECT_NEAR(ratio.mean, 1.2, 2e-3);
  EXPECT_LT(ratio.scatter_of_balls, 2e-3);
  EXPECT_LT(ratio.scatter_of_shots, 2e-3);
  ASSERT_TRUE(found.common_factor);
  EXPECT_NEAR(found.common_factor->factor, 1.2, 2e-3);
  EXPECT_LT(found.common_factor->reduced_chi_square, 0.1);
}

TEST(JointScalarsTest, OneFactorDoesNotMendWhatBallsDifferIn) {
  const JointConsistency found = compared_with(1.1, 1.3);
  ASSERT_TRUE(found.best());
  const JointRatio& ratio = *found.best()->of(ObservedQuantity::contact_time);
  EXPECT_NEAR(ratio.of_balls[0], 1.1, 2e-3);
  EXPECT_NEAR(ratio.of_balls[1], 1.3, 2e-3);
  EXPECT_NEAR(ratio.mean, std::sqrt(1.1 * 1.3), 2e-3);
  EXPECT_NEAR(ratio.scatter_of_balls, std::log(1.3 / 1.1) / std::sqrt(2.0), 2e-3);
  ASSERT_TRUE(found.common_factor);
  EXPECT_GT(found.common_factor->reduced_chi_square, 10.0);
  EXPECT_GT(found.common_factor->factor, 1.1);
  EXPECT_LT(found.common_factor->factor, 1.3);
  EXPECT_LT(found.common_factor->reduced_chi_square, found.all.reduced_chi_square);
}

TEST(EffectsOnScalarsTest, TheEffectThatIsThereComesFirst) {
  const EffectChoice hidden{.name = "strain-stiffening", .size = 2.0, .parameters = {}};
  const Observations all = scalars_of(law(3.2e6, 7e4), {hidden});
  const HypothesisFit fit = fit_hypothesis(all, {.believed = law(3.2e6, 7e4)});
  ASSERT_GT(fit.reduced_chi_square(), 2.0);
  const auto tried = try_effects(all, fit);
  ASSERT_FALSE(tried.empty());
  EXPECT_EQ(tried.front().effects.back().name, hidden.name);
  EXPECT_NEAR(tried.front().effects.back().size, hidden.size, 0.1);
  for (const HypothesisFit& one : tried) EXPECT_LT(one.chi_square, fit.chi_square);
}

TEST(AllScalarsTest, WhatHasNoErrorGetsTheAssumedOne) {
  const Dataset data = read_dataset(REBOUND_DATA_FOLDER "/sliotar-core-a");
  const Observations all = all_scalars(data, {.mean_deflection = 0.04, .pooled_peak = 0.2});
  ASSERT_EQ(all.shots.size(), 3u);
  const MeasuredImpact& slow = all.shots.front();
  EXPECT_DOUBLE_EQ(*slow.mean_deflection.uncertainty, 0.04 * 1.93e-3);
  EXPECT_DOUBLE_EQ(*slow.peak_force.value, 750.0);
  EXPECT_DOUBLE_EQ(*slow.peak_force.uncertainty, 150.0);
  EXPECT_DOUBLE_EQ(*slow.restitution.uncertainty, 0.01);  // stated
  for (const ScalarQuantity& scalar : scalar_quantities)
    EXPECT_TRUE((slow.*scalar.measured).has_error()) << scalar.key;
}

}  // namespace
}  // namespace rebound
