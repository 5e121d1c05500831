// Sizes and parameters act as the equations of the cards say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/effect_cases.hpp"

namespace rebound {
namespace {

// Unloading gives back ∫ x^1.5 [1 − s (1 − x/x_m)] dx, of the same without s: 1 − 2 s/7.
TEST(EffectFormsTest, HysteresisLosesTwoSeventhsOfItsSize) {
  for (const double size : {0.1, 0.35}) {
    const double e =
        simulate_fast(test::elastic_with({{"hysteresis", size, {}}})).scalars.restitution;
    EXPECT_NEAR(e * e, 1.0 - 2.0 * size / 7.0, 1e-5) << size;
  }
}

// In FE the force added is a factor on the stress of a point: where 1 − (1 − k/5)² of the largest
// strain is left, g over that to the 3/2, and never so much that the stress turns around.
TEST(EffectFormsTest, UnloadingWithoutAFormulaIsAFactorInFe) {
  const EffectChoice curve{
      "unloading-curve", 0.05, {{"at_0", -0.2}, {"at_1", -0.1}, {"at_3", 0.02}, {"at_4", 0.0}}};
  FemProblem problem;
  find_effect(curve.name).to_fem(curve, problem);
  const auto& factor = problem.material.strain.unloading.value;
  EXPECT_EQ(factor[0], -1.0);
  EXPECT_NEAR(factor[1], -0.1 / std::pow(0.36, 1.5), 1e-12);
  EXPECT_NEAR(factor[2], -0.05 / std::pow(0.64, 1.5), 1e-12);
  EXPECT_NEAR(factor[3], 0.02 / std::pow(0.84, 1.5), 1e-12);
  EXPECT_EQ(factor[4], 0.0);
}

// A branch that does not fade in the contact is stiffness, one that fades at once is nothing.
TEST(EffectFormsTest, ABranchFadesInItsRelaxationTime) {
  const double plain = simulate_fast(test::elastic_with({})).scalars.peak_force;
  const auto peak = [](double time) {
    const EffectChoice branch{"relaxation", 0.4, {{"relaxation_time", time}}};
    return simulate_fast(test::elastic_with({branch})).scalars.peak_force;
  };
  // Of m v²/2 = k x^2.5/2.5 the peak k x^1.5 grows with k^0.4.
  EXPECT_NEAR(peak(100.0) / plain, std::pow(1.4, 0.4), 1e-3);
  EXPECT_NEAR(peak(1e-7) / plain, 1.0, 1e-2);
}

TEST(EffectFormsTest, AnOddShotScalesItsTimeByAPowerOfItsForce) {
  MeasurementChain chain{.shot = 3};
  apply_effects({{"odd-shot", 0.2, {{"shot", 3.0}, {"time_exponent", 2.0}}}}, chain);
  EXPECT_DOUBLE_EQ(1.0 + chain.force_gain, 1.2);
  EXPECT_DOUBLE_EQ(1.0 + chain.time_base, 1.44);
}

// Hertz's law, with a damping that follows it, knows one time and one force.
TEST(EffectFormsTest, AnAgeingBallIsScaledAsItsStiffnessScalesIt) {
  constexpr double per_shot = 0.1;
  MeasurementChain third{.shot = 3};
  apply_effects({{"ageing", per_shot, {}}}, third);
  LumpedProblem first = test::elastic_with({});
  first.model.parameters["damping"] = 8e4;
  LumpedProblem stiffer = first;
  for (const char* name : {"stiffness", "damping"})
    stiffer.model.parameters[name] *= std::exp(2.0 * per_shot);
  const ImpactScalars before = simulate_fast(first).scalars, after = simulate_fast(stiffer).scalars;
  EXPECT_NEAR(1.0 + third.force_gain, after.peak_force / before.peak_force, 1e-6);
  EXPECT_NEAR(1.0 + third.time_base, after.contact_time / before.contact_time, 1e-6);
}

// What is looked for by frequency swings at it.
TEST(EffectFormsTest, AnOscillatorHasTheFrequencyThatItWasAskedFor) {
  constexpr double ball = 0.05;
  for (const Effect& effect : all_effects()) {
    if (!effect.card.oscillator) continue;
    for (const double frequency : {300.0, 2500.0})
      for (const double strength : {0.02, 0.3}) {
        const EffectChoice choice = effect.card.oscillator->with(frequency, strength, ball);
        EXPECT_NEAR(effect.card.oscillator->frequency_of(choice) / frequency, 1.0, 1e-12)
            << effect.card.name;
        LumpedProblem problem = test::problem_for_effects();
        apply_effects({choice}, problem);
        const Plate& plate = problem.model.mechanisms.plate;
        if (!plate.moves()) continue;
        EXPECT_NEAR(std::sqrt(plate.stiffness / plate.mass), 2.0 * std::numbers::pi * frequency,
                    1e-6)
            << effect.card.name;
        EXPECT_NEAR(ball / plate.mass, strength, 1e-12);
      }
  }
}

/// Another value of a parameter, within its range.
double another_value(const EffectParameterCard& parameter) {
  if (parameter.kind == ParameterKind::shot) return parameter.default_value + 1.0;
  const double step = 0.1 * std::max(std::abs(parameter.default_value), 1e-3 * parameter.scale);
  const double above = parameter.default_value + step;
  return parameter.range.contains(above) ? above : parameter.default_value - step;
}

template <class Record>
Record applied(const EffectChoice& choice, Record record) {
  apply_effects({choice}, record);
  return record;
}

class EffectParameters : public ::testing::TestWithParam<Effect> {};

TEST_P(EffectParameters, NoneIsIgnored) {
  const Effect& effect = GetParam();
  const EffectChoice usual = test::at_prior_scale(effect);
  for (const EffectParameterCard& parameter : effect.card.parameters) {
    SCOPED_TRACE(parameter.name);
    EffectChoice other = usual;
    other.parameters[parameter.name] = another_value(parameter);
    if (effect.to_lumped) {
      EXPECT_NE(applied(other, test::problem_for_effects()),
                applied(usual, test::problem_for_effects()));
    }
    if (effect.to_fem && parameter.in_fem) {
      EXPECT_NE(applied(other, test::fem_problem_for_effects()),
                applied(usual, test::fem_problem_for_effects()));
    } else if (effect.to_fem && parameter.kind != ParameterKind::largest_deflection) {
      EXPECT_THROW(applied(other, test::fem_problem_for_effects()), Error);
    }
    if (effect.to_measurement) {
      const MeasurementChain first{.shot = 1};
      EXPECT_NE(applied(other, first), applied(usual, first));
    }
  }
}

std::vector<Effect> with_parameters() {
  std::vector<Effect> effects;
  for (const Effect& effect : all_effects())
    if (!effect.card.parameters.empty()) effects.push_back(effect);
  return effects;
}

INSTANTIATE_TEST_SUITE_P(EveryEffect, EffectParameters, ::testing::ValuesIn(with_parameters()),
                         [](const auto& instance) {
                           std::string name = instance.param.card.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace rebound
