// One battery over the list of effects: what must hold of every one of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/effect_cases.hpp"

namespace rebound {

Effect blank_effect();  // of blank_effect.cpp

namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

LumpedProblem with(const std::vector<EffectChoice>& effects) {
  LumpedProblem problem = test::problem_for_effects();
  apply_effects(effects, problem);
  return problem;
}

void expect_same_trace(const Trace& a, const Trace& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.deflection, b.deflection);
  EXPECT_EQ(a.further.size(), b.further.size());
}

void expect_closed(const Closures& closures) {
  EXPECT_LT(closures.impulse, 1e-8);
  EXPECT_LT(closures.energy, 1e-6);
}

std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class EffectBattery : public ::testing::TestWithParam<Effect> {
 protected:
  const Effect& effect_ = GetParam();
};

TEST_P(EffectBattery, CardIsComplete) {
  const EffectCard& card = effect_.card;
  for (const std::string* text : {&card.name, &card.sentence, &card.equation, &card.signature,
                                  &card.experiment, &card.source})
    EXPECT_FALSE(text->empty());
  EXPECT_LT(card.range.lowest, card.range.highest);
  EXPECT_GE(card.prior_scale, card.range.lowest);
  EXPECT_LE(card.prior_scale, card.range.highest);
  EXPECT_NE(card.prior_scale, card.null);
  if (card.tried_in == TriedIn::si) {
    for (const double tried : card.tried) EXPECT_TRUE(card.range.contains(tried));
  }
  EXPECT_EQ(find_effect(card.name).card.name, card.name);
  EXPECT_EQ(effect_.to_measurement != nullptr, card.kind == EffectKind::measurement);
  EXPECT_NE(card.family, EffectFamily::none) << "what the missing force depends on";
  EXPECT_EQ(card.family == EffectFamily::measurement, card.kind == EffectKind::measurement);
  EXPECT_TRUE(effect_.to_lumped || effect_.to_fem || effect_.to_measurement);
  EXPECT_EQ(card.moves.has_value(), effect_.to_fem != nullptr)
      << "what it moves in an FE impact is checked against the card";
  for (const EffectParameterCard& parameter : card.parameters) {
    EXPECT_LE(parameter.range.lowest, parameter.default_value);
    EXPECT_LE(parameter.default_value, parameter.range.highest);
    EXPECT_GT(parameter.scale, 0.0);
    if (parameter.tried_in == TriedIn::si) {
      for (const double tried : parameter.tried) EXPECT_TRUE(parameter.range.contains(tried));
    }
    EXPECT_FALSE(parameter.kind == ParameterKind::shot && parameter.fitted);
    // The unknown of a fit is the logarithm.
    const bool logarithm = parameter.fitted && parameter.kind == ParameterKind::logarithmic;
    EXPECT_TRUE(!logarithm || parameter.is_left_open || parameter.default_value > 0.0);
  }
}

TEST_P(EffectBattery, NullLeavesAllAsItWas) {
  const EffectChoice null = test::null_of(effect_);
  if (effect_.to_lumped) {
    const LumpedProblem plain = test::problem_for_effects(), same = with({null});
    EXPECT_EQ(same, plain);
    expect_same_trace(simulate_fast(same).trace, simulate_fast(plain).trace);
    expect_same_trace(simulate(same).trace, simulate(plain).trace);
  }
  if (effect_.to_fem) {
    FemProblem problem = test::fem_problem_for_effects();
    apply_effects({null}, problem);
    EXPECT_EQ(problem, test::fem_problem_for_effects());
  }
  MeasurementChain chain;
  apply_effects({null}, chain);
  EXPECT_EQ(chain, MeasurementChain{});
}

TEST_P(EffectBattery, ASmallSizeShows) {
  if (effect_.to_lumped) {
    const LumpedResult plain = simulate_fast(test::problem_for_effects());
    const LumpedResult changed = simulate_fast(with({test::slight(effect_)}));
    const double difference = largest_difference(changed.trace.force, plain.trace.force);
    EXPECT_GT(difference, 2e-6 * plain.scalars.peak_force);
    EXPECT_LT(difference, 0.2 * plain.scalars.peak_force);
  }
  if (effect_.to_fem) {
    FemProblem problem = test::fem_problem_for_effects();
    apply_effects({test::slight(effect_)}, problem);
    EXPECT_NE(problem, test::fem_problem_for_effects());
  }
  if (effect_.to_measurement) {
    // A ball that changes from shot to shot is in the first as it was.
    const MeasurementChain of_shot{.shot = effect_.card.follows_shot_order ? 2 : 1};
    MeasurementChain chain = of_shot;
    apply_effects({test::at_prior_scale(effect_)}, chain);
    EXPECT_NE(chain, of_shot);
  }
}

TEST_P(EffectBattery, EnergyBalanceClosesAndCvodeAgreesWithTheFastPath) {
  if (!effect_.to_lumped) return;
  for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
    LumpedProblem problem = with({test::at_prior_scale(effect_)});
    problem.impact.separation = rule;
    const LumpedResult fast = simulate_fast(problem), cvode = simulate(problem);
    expect_closed(fast.closures);
    expect_closed(cvode.closures);
    EXPECT_NEAR(fast.scalars.restitution, cvode.scalars.restitution, 1e-6);
    EXPECT_NEAR(fast.scalars.contact_time / cvode.scalars.contact_time, 1.0, 1e-6);
    EXPECT_LT(largest_difference(fast.trace.force, cvode.trace.force),
              1e-5 * fast.scalars.peak_force);
    EXPECT_LT(largest_difference(fast.trace.deflection, cvode.trace.deflection),
              1e-6 * fast.scalars.peak_deflection);
  }
}

TEST_P(EffectBattery, FileKeepsEveryBit) {
  EffectChoice choice = test::at_prior_scale(effect_);
  choice.size *= 1.0 / 3.0 + 0.5;
  for (const EffectParameterCard& parameter : effect_.card.parameters)
    choice.parameters[parameter.name] = parameter.default_value * (1.0 + 1.0 / 7.0);
  const LumpedImpactFile file{.problem = test::problem_for_effects(), .effects = {choice}};
  const std::string text = write_toml(file);
  SCOPED_TRACE(text);
  const Document document = Document::parse(text, "f");
  if (effect_.to_lumped || effect_.to_measurement) {
    const LumpedImpactFile read = read_lumped_impact(document);
    ASSERT_EQ(read.effects.size(), 1u);
    EXPECT_EQ(read.effects[0], choice);
    EXPECT_EQ(read.problem, [&] {
      LumpedProblem plain = test::problem_for_effects();
      return plain;
    }());
    EXPECT_EQ(write_toml(read), text);
  }
  if (effect_.to_lumped) {
    EXPECT_EQ(read_lumped_problem(document), with({choice}));
  } else {
    EXPECT_THROW(read_lumped_problem(document), Error);
  }
}

TEST_P(EffectBattery, RefusesWhatIsOutOfRange) {
  const EffectCard& card = effect_.card;
  LumpedProblem problem = test::problem_for_effects();
  MeasurementChain chain;
  for (const double size :
       {card.range.lowest - 1.0, card.range.highest * 1.01 + 1.0, std::nan("")}) {
    const std::vector<EffectChoice> effects = {{card.name, size, {}}};
    if (effect_.to_measurement)
      EXPECT_THROW(apply_effects(effects, chain), Error) << size;
    else
      EXPECT_THROW(apply_effects(effects, problem), Error) << size;
  }
  EXPECT_THROW(apply_effects({{card.name, card.prior_scale, {{"colour", 1.0}}}}, chain), Error);
  EXPECT_EQ(problem, test::problem_for_effects());
}

TEST(BlankEffectTest, IsAnEffectInNoList) {
  const Effect blank = blank_effect();
  EXPECT_THROW(find_effect(blank.card.name), Error);
  LumpedProblem lumped = test::problem_for_effects();
  blank.to_lumped({.name = "blank", .size = 0.5, .parameters = {}}, lumped);
  EXPECT_EQ(lumped.model.parameters.at("stiffness"),
            1.5 * test::problem_for_effects().model.parameters.at("stiffness"));
  FemProblem fem = test::fem_problem_for_effects();
  blank.to_fem({.name = "blank", .size = 0.5, .parameters = {}}, fem);
  EXPECT_EQ(fem.material.youngs_modulus,
            1.5 * test::fem_problem_for_effects().material.youngs_modulus);
}

INSTANTIATE_TEST_SUITE_P(EveryEffect, EffectBattery, ::testing::ValuesIn(all_effects()),
                         [](const auto& instance) { return test_name(instance.param.card.name); });

/// All but those that contain another one of the list: a ball hits one plate.
std::vector<EffectChoice> all_lumped_effects() {
  std::vector<EffectChoice> effects;
  for (const Effect& effect : all_effects())
    if (effect.to_lumped && effect.card.contains.empty())
      effects.push_back(test::at_prior_scale(effect));
  return effects;
}

// Every pair, and every three neighbours of the list: energy balances close and the two
// integrators agree.
void expect_sound(const std::vector<EffectChoice>& effects) {
  std::string names;
  for (const EffectChoice& effect : effects) names += effect.name + " ";
  SCOPED_TRACE(names);
  const LumpedProblem problem = with(effects);
  const LumpedResult fast = simulate_fast(problem), cvode = simulate(problem);
  expect_closed(fast.closures);
  expect_closed(cvode.closures);
  EXPECT_NEAR(fast.scalars.restitution, cvode.scalars.restitution, 1e-6);
  EXPECT_NEAR(fast.scalars.contact_time / cvode.scalars.contact_time, 1.0, 1e-6);
}

TEST(EffectCompositionTest, PairsAreSound) {
  const auto effects = all_lumped_effects();
  for (std::size_t i = 0; i < effects.size(); ++i)
    for (std::size_t j = i + 1; j < effects.size(); ++j) expect_sound({effects[i], effects[j]});
}

TEST(EffectCompositionTest, ThreesAreSound) {
  const auto effects = all_lumped_effects();
  for (std::size_t i = 0; i < effects.size(); ++i)
    expect_sound(
        {effects[i], effects[(i + 5) % effects.size()], effects[(i + 11) % effects.size()]});
}

TEST(EffectCompositionTest, OrderDoesNotMatter) {
  auto effects = all_lumped_effects();
  const LumpedProblem forwards = with(effects);
  std::reverse(effects.begin(), effects.end());
  EXPECT_EQ(with(effects), forwards);
}

}  // namespace
}  // namespace rebound
