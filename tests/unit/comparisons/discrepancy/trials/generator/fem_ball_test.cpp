// Balls in finite elements: what a trial writes into a deck, and what it reads of an impact.
#include "comparisons/discrepancy/trials/generator/fem_ball.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"
#include "comparisons/discrepancy/trials/generator/fem_program.hpp"
#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/discrepancy/trials/generator/example.hpp"

namespace trials {
namespace {

constexpr FemImpact impact{.mass = 0.09, .radius = 0.033, .speed = 15.0};

HiddenWorld body() {
  Random random({.seed = 1, .set = "test"});
  HiddenWorld world = testing::baseline_world(0.2);
  world.fem = draw_material(1e7, testing::example_scales(0.2).contact_time, fem_materials().front(),
                            random);
  return world;
}

HiddenWorld body_with(const EffectForm& form, double size) {
  HiddenWorld world = body();
  apply(testing::example_effect(form, size), testing::example_scales(0.2), world);
  return world;
}

const EffectForm& fem_form(const std::string& name) {
  for (const EffectForm& form : all_fem_forms())
    if (form.name == name) return form;
  throw std::runtime_error("no form " + name);
}

TEST(FemMaterials, AreEightOfFourLawsAndFivePoissonRatios) {
  std::set<std::string> names, laws;
  std::set<double> ratios;
  for (const FemBall& ball : fem_materials()) {
    names.insert(ball.material);
    laws.insert(ball.elastic);
    ratios.insert(ball.poisson_ratio);
    EXPECT_EQ(ball.material.find_first_of(",|\n"), std::string::npos) << "it stands in a table";
  }
  EXPECT_EQ(names.size(), 8u);
  EXPECT_EQ(laws.size(), 4u);
  EXPECT_EQ(ratios.size(), 5u);
}

/// They are loss and no memory.
TEST(FemMaterials, BranchesHaveFadedWithinATwelfthOfTheContact) {
  constexpr double contact_time = 1e-3;
  for (int trial = 0; trial < 20; ++trial)
    for (const FemBall& kind : fem_materials()) {
      Random random({.seed = 2, .set = "test", .trial = trial});
      for (const FemBranch& branch : draw_material(1e7, contact_time, kind, random).branches) {
        EXPECT_GT(branch.ratio, 0.0);
        EXPECT_LE(branch.time, contact_time / 12.0);
      }
    }
}

TEST(FemForms, EveryFormChangesTheDeckOrTheChainAndNoneDoesAtSizeZero) {
  const std::string plain = deck_text(body().fem, impact);
  std::set<std::string> families;
  for (const EffectForm& form : all_fem_forms()) {
    families.insert(form.family);
    EXPECT_EQ(deck_text(body_with(form, 0.0).fem, impact), plain) << form.name;
    const std::string hidden = deck_text(body_with(form, form.smallest).fem, impact);
    EXPECT_EQ(hidden == plain, form.family == "measurement") << form.name;
    EXPECT_FALSE(form.registry_name.empty() && form.family != "measurement") << form.name;
  }
  EXPECT_EQ(families, (std::set<std::string>{"dynamics", "elastic", "history", "measurement",
                                             "memory", "surface"}));
}

TEST(FemForms, ASpectrumOfBranchesFollowsAStretchedExponential) {
  constexpr double size = 0.7;
  const EffectForm& form = fem_form("stretched-spectrum");
  const HiddenEffect effect = testing::example_effect(form, size);
  const Scales scales = testing::example_scales(0.2);
  HiddenWorld world = body();
  const std::size_t own = world.fem.branches.size();
  apply(effect, scales, world);
  ASSERT_GT(world.fem.branches.size(), own + 4);
  const double tau = effect.parameters.at("tau_over_T") * scales.contact_time;
  for (const double share : {0.05, 0.3, 1.0, 3.0}) {
    double sum = 0.0;
    for (std::size_t k = own; k < world.fem.branches.size(); ++k)
      sum += world.fem.branches[k].ratio * std::exp(-share * tau / world.fem.branches[k].time);
    const double wanted = size * std::exp(-std::pow(share, effect.parameters.at("beta")));
    EXPECT_NEAR(sum, wanted, 0.01 * size) << share;
  }
}

/// A load cell that rings is the plate's own vibration, and known exactly.
TEST(FemRecord, ALoadCellRingsOnAsThePlateDoes) {
  const FemPlate plate{.stiffness = 3e7, .mass = 2.0, .damping_ratio = 0.05};
  const double natural = std::sqrt(plate.stiffness / plate.mass);
  const double decay = plate.damping_ratio * natural,
               frequency = natural * std::sqrt(1.0 - std::pow(plate.damping_ratio, 2));
  const auto exact = [&](double t) {
    return 50.0 * std::exp(-decay * t) * std::sin(frequency * t);
  };
  SimulatedImpact record{.start = 0.0, .step = 1e-6};
  for (int i = 0; i < 300; ++i) record.force.push_back(exact(i * record.step));
  let_ring_on(plate, 1e-3, record);
  ASSERT_EQ(record.force.size(), 1300u);
  for (std::size_t i = 300; i < 1300; i += 50)
    EXPECT_NEAR(record.force[i], exact(static_cast<double>(i) * record.step), 0.05);
}

// A faster one is excited by nodes that touch one by one: what would be hidden is the mesh.
TEST(FemForms, APlateRingsAFewTimesInAContact) {
  const EffectForm& form = fem_form("plate-under-ball");
  const Scales scales = testing::example_scales(0.2);
  HiddenWorld world = body();
  const double lightest = form.secondary.front().from;
  form.apply(form.smallest, {{"mass_ratio", lightest}}, scales, world);
  const double frequency =
      std::sqrt(world.fem.plate->stiffness / world.fem.plate->mass) / (2.0 * std::numbers::pi);
  EXPECT_LT(frequency * scales.contact_time, 6.0);
}

class FemResult : public ::testing::Test {
 protected:
  rebound::testing::TemporaryFolder folder_;
};

TEST_F(FemResult, IsReadInEqualSteps) {
  folder_.write("result.json", "{\"contact_time_s\": 1e-3, \"restitution\": 0.8}");
  std::string trace = "time_s,force_N,deflection_m\n";
  for (int i = 0; i <= 200; ++i) {
    const double time = i * 5e-6;
    trace += fmt::format("{},{},0\n", time, 100.0 * std::sin(std::numbers::pi * time / 1e-3));
  }
  folder_.write("trace.csv", trace);
  const SimulatedImpact read = read_fem_impact(folder_.path());
  EXPECT_EQ(read.restitution, 0.8);
  EXPECT_NEAR(read.peak_force, 100.0, 1e-6);
  EXPECT_EQ(read.step, 1e-3 / 2000.0);
  EXPECT_NEAR(read.at(0.3e-3 + 1.3e-6), 100.0 * std::sin(std::numbers::pi * 0.3013), 0.02);
}

TEST_F(FemResult, WithoutARecordOfTheForceIsRefused) {
  folder_.write("result.json", "{\"contact_time_s\": 1e-3, \"restitution\": 0.8}");
  folder_.write("trace.csv", "time_s,deflection_m\n0,0\n");
  EXPECT_THROW(read_fem_impact(folder_.path()), std::runtime_error);
}

TEST(FemProgramTest, WhatIsNoProgramIsRefused) {
  EXPECT_THROW(FemProgram("/nowhere/rebound"), std::runtime_error);
}

class FemProgramThatEnds : public ::testing::Test {
 protected:
  /// With that exit code, whatever it is asked.
  void run_one_that_ends_with(int code) {
    const auto program = folder_.write("program", fmt::format("#!/bin/sh\nexit {}\n", code));
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    FemProgram(program).impact(body().fem, impact);
  }
  rebound::testing::TemporaryFolder folder_;
};

TEST_F(FemProgramThatEnds, WithoutAResultHasNoImpact) {
  EXPECT_THROW(run_one_that_ends_with(2), NoRebound);
  EXPECT_THROW(run_one_that_ends_with(3), NoRebound);
}

// Else another ball would be drawn for ever.
TEST_F(FemProgramThatEnds, WithAnotherCodeDoesNotWork) {
  for (const int code : {1, 4, 127}) {
    try {
      run_one_that_ends_with(code);
      FAIL() << "code " << code;
    } catch (const NoRebound&) {
      FAIL() << "code " << code << " is taken for a ball without a rebound";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(fmt::format("exit code {}", code)),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace trials
