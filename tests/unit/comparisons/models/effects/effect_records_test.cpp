// The number of an effect is the number of the mechanism that its equation names, once and with its
// sign: in the lumped problem, in the FE problem and in the chain of the measurement.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/effect_cases.hpp"

namespace rebound {
namespace {

/// An effect, and what the record is with it.
template <class Record>
struct Written {
  EffectChoice choice;
  std::function<void(Record&)> edit;
};

template <class Record>
void expect_written(const Record& plain, const std::vector<Written<Record>>& all) {
  for (const auto& [choice, edit] : all) {
    Record found = plain, expected = plain;
    apply_effects({choice}, found);
    edit(expected);
    EXPECT_EQ(found, expected) << choice.name;
    EXPECT_NE(found, plain) << choice.name;
  }
}

TEST(EffectRecordsTest, OneNumberOfTheLumpedProblem) {
  const auto of = [](auto edit) {
    return [edit](LumpedProblem& problem) { edit(problem.model.mechanisms); };
  };
  expect_written<LumpedProblem>(
      test::problem_for_effects(),
      {{{"adhesion", 3.0, {}}, of([](auto& m) { m.adhesion = 3.0; })},
       {{"damping-exponent", 0.3, {}}, of([](auto& m) { m.damping.exponent = 0.3; })},
       {{"velocity-exponent", 0.3, {}}, of([](auto& m) { m.damping.velocity_exponent = 0.3; })},
       {{"linear-dashpot", 7.0, {}}, of([](auto& m) { m.damping.dashpot = 7.0; })},
       {{"hysteresis", 0.3, {}}, of([](auto& m) { m.memory.hysteresis = 0.3; })},
       {{"permanent-set", 0.3, {}}, of([](auto& m) { m.memory.permanent_set = 0.3; })},
       {{"force-exponent", 0.3, {}}, of([](auto& m) { m.elastic.exponent = 0.3; })},
       {{"strain-stiffening", 0.3, {}}, of([](auto& m) { m.elastic.stiffening = 0.3; })},
       {{"foam-softening", 0.3, {}}, of([](auto& m) { m.elastic.softening = 0.3; })},
       {{"densification", 0.3, {}}, of([](auto& m) { m.elastic.densification = 0.3; })},
       {{"layered-core", 0.3, {}}, of([](auto& m) { m.elastic.layer = 0.3; })},
       {{"rate-stiffening", 0.3, {}}, of([](auto& m) { m.elastic.rate_exponent = 0.3; })},
       {{"gravity", 0.5, {}}, of([](auto& m) { m.gravity = 0.5 * 9.80665; })}});
}

TEST(EffectRecordsTest, SeveralNumbersOfTheLumpedProblem) {
  const auto of = [](auto edit) {
    return [edit](LumpedProblem& problem) { edit(problem.model.mechanisms); };
  };
  expect_written<LumpedProblem>(
      test::problem_for_effects(),
      {{{"relaxation", 0.3, {{"relaxation_time", 2e-3}}},
        of([](auto& m) { m.relaxation = {.ratio = 0.3, .relaxation_time = 2e-3}; })},
       {{"relaxation-spectrum",
         0.3,
         {{"fast_ratio", 0.1}, {"slow_ratio", 0.2}, {"relaxation_time", 6e-4}}},
        of([](auto& m) {
          m.relaxation = {.ratio = 0.3, .relaxation_time = 6e-4};
          m.further_relaxation = {RelaxationBranch{.ratio = 0.1, .relaxation_time = 6e-4 / 6.0},
                                  RelaxationBranch{.ratio = 0.2, .relaxation_time = 6e-4 * 6.0}};
        })},
       {{"finite-sphere", 1.0, {{"poisson_ratio", 0.3}}},
        of([](auto& m) { m.finite_sphere = {.share = 1.0, .poisson_ratio = 0.3}; })},
       {{"internal-mode", 0.2, {{"frequency", 900.0}, {"damping_ratio", 0.1}}}, of([](auto& m) {
          m.mode = {.mass_fraction = 0.2, .frequency = 900.0, .damping_ratio = 0.1};
        })},
       {{"plate-compliance", 2e-8, {{"mass", 3.0}, {"damping_ratio", 0.1}}}, of([](auto& m) {
          m.plate.stiffness = 1.0 / 2e-8;
          m.plate.mass = 3.0;
          m.plate.damping_ratio = 0.1;
        })}});
}

// The damper's curve runs over (x/R)^(1/4); damping follows an elastic curve in the share that is
// asked.
TEST(EffectRecordsTest, CurvesReachWhereTheirCardsSay) {
  LumpedProblem damped = test::problem_for_effects();
  apply_effects({{"damping-curves",
                  0.2,
                  {{"deflection_reach", 0.0081}, {"deflection_3", 0.4}, {"rate_reach", 12.0}}}},
                damped);
  const DampingFactors& damping = damped.model.mechanisms.damping;
  EXPECT_DOUBLE_EQ(damping.added.end, 0.3);
  EXPECT_EQ(damping.added.value[3], 0.4);
  EXPECT_EQ(damping.rate_curve.end, 12.0);
  EXPECT_EQ(damping.rate_curve.value[2], 0.2);

  LumpedProblem elastic = test::problem_for_effects();
  apply_effects({{"elastic-curve", 0.4, {{"reach", 0.2}, {"at_1", 0.2}, {"damping_share", 0.25}}}},
                elastic);
  const Mechanisms& mechanisms = elastic.model.mechanisms;
  EXPECT_EQ(mechanisms.elastic.curve.value.back(), 0.4);
  EXPECT_EQ(mechanisms.elastic.curve.end, 0.2);
  EXPECT_DOUBLE_EQ(mechanisms.damping.elastic.curve.value.back(), 0.1);
  EXPECT_DOUBLE_EQ(mechanisms.damping.elastic.curve.value[1], 0.05);
}

// Each factor by its own number of its shape, and the damping by the share that is asked.
TEST(EffectRecordsTest, DampingFollowsAnElasticFactorInItsShare) {
  const auto of = [](auto edit) {
    return [edit](LumpedProblem& problem) {
      Mechanisms& m = problem.model.mechanisms;
      edit(m.elastic, 0.4);
      edit(m.damping.elastic, 0.1);
    };
  };
  expect_written<LumpedProblem>(
      test::problem_for_effects(),
      {{{"force-exponent", 0.4, {{"damping_share", 0.25}}},
        of([](ElasticFactors& f, double size) { f.exponent = size; })},
       {{"strain-stiffening", 0.4, {{"damping_share", 0.25}, {"power", 2.0}}},
        of([](ElasticFactors& f, double size) {
          f.stiffening = size;
          f.stiffening_power = 2.0;
        })},
       {{"foam-softening", 0.4, {{"damping_share", 0.25}, {"depth_over_radius", 0.02}}},
        of([](ElasticFactors& f, double size) {
          f.softening = size;
          f.softening_depth = 0.02;
        })},
       {{"densification", 0.4, {{"damping_share", 0.25}, {"onset_over_radius", 0.1}}},
        of([](ElasticFactors& f, double size) {
          f.densification = size;
          f.densification_onset = 0.1;
        })},
       {{"layered-core", 0.4, {{"damping_share", 0.25}, {"depth_over_radius", 0.03}}},
        of([](ElasticFactors& f, double size) {
          f.layer = size;
          f.layer_depth = 0.03;
        })}});
}

// A body of branches has no damping that could follow or not: FE takes the form without it.
TEST(EffectRecordsTest, InFemAFactorHasNoShareOfTheDamping) {
  const EffectChoice lumped{
      "foam-softening", 0.3, {{"damping_share", 1.0}, {"depth_over_radius", 0.02}}};
  FemProblem problem = test::fem_problem_for_effects();
  EXPECT_THROW(apply_effects({lumped}, problem), Error);
  apply_effects({form_in_fem(lumped)}, problem);
  EXPECT_EQ(problem.material.strain.softening, 0.3);
}

TEST(EffectRecordsTest, AFreeFormOfOneEffectIsThatEffectByAnotherLaw) {
  EXPECT_EQ(effect_behind("pull-curves"), "adhesion");
  EXPECT_EQ(effect_behind("adhesion"), "adhesion");
  // Five effects are a factor over the deflection: the curve says none of them.
  EXPECT_EQ(effect_behind("elastic-curve"), "elastic-curve");
  for (const Effect& effect : all_effects()) {
    if (effect.card.free_form_of.empty()) continue;
    const EffectCard& behind = find_effect(effect.card.free_form_of).card;
    EXPECT_TRUE(effect.card.is_free_form);
    EXPECT_FALSE(behind.is_free_form);
    EXPECT_EQ(behind.family, effect.card.family);
  }
}

TEST(EffectRecordsTest, OfTheFeProblem) {
  expect_written<FemProblem>(
      test::fem_problem_for_effects(),
      {{{"adhesion", 3.0, {}}, [](FemProblem& p) { p.adhesion.work = 3.0; }},
       {{"gravity", 0.5, {}}, [](FemProblem& p) { p.gravity = 0.5 * 9.80665; }},
       {{"plate-friction", 0.3, {}}, [](FemProblem& p) { p.plate.friction = 0.3; }},
       {{"hysteresis", 0.3, {}}, [](FemProblem& p) { p.material.strain.mullins = 0.3; }},
       {{"strain-stiffening", 0.3, {}}, [](FemProblem& p) { p.material.strain.stiffening = 0.3; }},
       {{"foam-softening", 0.3, {}}, [](FemProblem& p) { p.material.strain.softening = 0.3; }},
       {{"densification", 0.3, {}}, [](FemProblem& p) { p.material.strain.densification = 0.3; }},
       {{"layered-core", 0.3, {}},
        [](FemProblem& p) { p.material.layers = {{.from = 0.8, .modulus_factor = 1.3}}; }},
       {{"velocity-exponent", 0.3, {}}, [](FemProblem& p) {
          PronyBranch& branch = p.material.branches.front();
          branch.rate_exponent = 1.3;
          // 10 m/s over the diameter, in the time of the branch
          branch.reference_strain = 10.0 / p.sphere.diameter * branch.relaxation_time;
        }}});
}

TEST(EffectRecordsTest, OfTheChain) {
  using Chain = MeasurementChain;
  expect_written<Chain>(
      {.shot = 2},
      {{{"force-gain", 0.1, {}}, [](Chain& c) { c.force_gain = 0.1; }},
       {{"force-baseline", -4.0, {}}, [](Chain& c) { c.force_baseline = -4.0; }},
       {{"force-drift", 50.0, {}}, [](Chain& c) { c.force_drift = 50.0; }},
       {{"mass", 0.1, {}}, [](Chain& c) { c.mass_error = 0.1; }},
       {{"speed-calibration", 0.1, {}}, [](Chain& c) { c.speed_error = 0.1; }},
       {{"trigger-shift", 1e-5, {}}, [](Chain& c) { c.trigger_shift = 1e-5; }},
       {{"time-base", 0.01, {}}, [](Chain& c) { c.time_base = 0.01; }},
       {{"integration-drift", 5.0, {}}, [](Chain& c) { c.integration_drift = 5.0; }},
       {{"contact-time-threshold", 9.0, {}}, [](Chain& c) { c.contact_threshold = 9.0; }},
       {{"bandwidth", 4e3, {}}, [](Chain& c) { c.bandwidth = 4e3; }},
       {{"clipping", 4e3, {}}, [](Chain& c) { c.clipping_level = 4e3; }},
       {{"quantisation", 20.0, {}}, [](Chain& c) { c.rounding_step = 20.0; }},
       {{"droop", 30.0, {}}, [](Chain& c) { c.droop = 30.0; }},
       {{"sensor-lag", 4e-5, {{"second_share", 0.25}}},
        [](Chain& c) {
          c.lag = 4e-5;
          c.second_lag = 1e-5;
        }},
       {{"hum", 9.0, {{"frequency", 700.0}, {"phase", 0.4}}},
        [](Chain& c) { c.hum = {.amplitude = 9.0, .frequency = 700.0, .phase = 0.4}; }},
       {{"burst", 9.0, {{"frequency", 4e3}, {"decay_time", 1e-3}, {"instant", 2e-4}}},
        [](Chain& c) {
          c.burst = {.amplitude = 9.0, .frequency = 4e3, .decay_time = 1e-3, .instant = 2e-4};
        }},
       {{"shot-gain", 0.1, {{"shot", 2.0}}}, [](Chain& c) { c.force_gain = 0.1; }},
       {{"shot-speed", 0.1, {{"shot", 2.0}}}, [](Chain& c) { c.speed_error = 0.1; }}});
}

// A network beside the material carries s of what both carry: s/(1 − s) of the material.
TEST(EffectRecordsTest, APermanentSetIsTheShareOfTheNetworkThatYields) {
  FemProblem problem = test::fem_problem_for_effects();
  problem.material.branches.clear();
  problem.material.modulus = ModulusBasis::long_term;
  apply_effects({{"permanent-set", 0.2, {}}}, problem);
  ASSERT_EQ(problem.material.branches.size(), 1u);
  EXPECT_DOUBLE_EQ(problem.material.branches[0].ratio, 0.25);
}

// The spectrum has the stiffness of the material at half the contact time of Hertz's impact at
// 10 m/s, which an integrated impact tells without the formula.
TEST(EffectRecordsTest, RateStiffeningLeavesTheStiffnessAtTenMetresPerSecond) {
  FemProblem problem = test::fem_problem_for_effects();
  problem.material.branches.clear();
  const double before = problem.material.youngs_modulus;
  const double nu = problem.material.poisson_ratio, radius = problem.sphere.radius();
  LumpedProblem hertz{.sphere = problem.sphere, .impact = {.speed = 10.0}};
  hertz.model.law = "hunt-crossley";
  hertz.model.parameters = {{"exponent", 1.5},
                            {"stiffness", 4.0 / 3.0 * before / (1.0 - nu * nu) * std::sqrt(radius)},
                            {"damping", 0.0}};
  const double time = 0.5 * simulate_fast(hertz).scalars.contact_time;
  apply_effects({{"rate-stiffening", 0.2, {}}}, problem);
  double modulus = 1.0;
  for (const PronyBranch& branch : problem.material.branches)
    modulus += branch.ratio * std::exp(-time / branch.relaxation_time);
  EXPECT_NEAR(problem.material.youngs_modulus * modulus / before, 1.0, 1e-4);
}

}  // namespace
}  // namespace rebound
