// A pull along curves against closed forms. F_r is 1 N here: curves are in newtons.
#include "lumped/mechanisms/pull_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"
#include "tests/support/mechanism_cases.hpp"

namespace rebound {
namespace {

using test::elastic_problem;
using test::hertz;
using test::stiffness;
using test::with;

constexpr double reach = 0.2;  // over R

double newtons(double pull) {
  return pull / (stiffness * std::pow(reach * elastic_problem().sphere.radius(), 1.5));
}

PullCurves constant_pull(double pull, double gap_reach) {
  PullCurves curves{.contact = {.end = 1.0},
                    .unloading = {.end = 1.0},
                    .beyond = {.end = 1.0},
                    .deflection_reach = reach,
                    .gap_reach = gap_reach};
  curves.contact.value.fill(newtons(pull));
  return curves;
}

/// What is left beyond the plate falls off as 1 − √(gap/G).
FactorCurve fall() {
  FactorCurve curve{.end = 1.0};
  for (std::size_t k = 0; k < FactorCurve::points; ++k)
    curve.value[k] = -0.2 * static_cast<double>(k);
  return curve;
}

double energy_left(const LumpedResult& result) {
  return 0.5 * 0.0896 * 225.0 * std::pow(result.scalars.restitution, 2);
}

// m ẍ = P − κ x^1.5 from rest at the turning point: the largest deflection x_m has
// ½ m v² + P x_m = 2/5 κ x_m^2.5.
TEST(PullCurvesTest, AConstantPullTakesNoEnergy) {
  const auto result = simulate_fast(
      with(elastic_problem(), [](Mechanisms& m) { m.pull = constant_pull(200.0, 0.0); }));
  EXPECT_NEAR(result.scalars.restitution, 1.0, 1e-7);
  EXPECT_NEAR(result.trace.force.front(), -200.0, 1e-6);
  EXPECT_NEAR(result.trace.force.back(), -200.0, 1e-6);
  const double x = result.scalars.peak_deflection;
  EXPECT_NEAR(0.4 * stiffness * std::pow(x, 2.5), 0.5 * 0.0896 * 225.0 + 200.0 * x, 1e-3);
}

// ∫ P [1 − √(gap/G)] dgap = P G/3.
TEST(PullCurvesTest, APullBeyondThePlateTakesItsArea) {
  constexpr double gap = 0.05;  // over R
  const auto problem = with(elastic_problem(), [](Mechanisms& m) {
    m.pull = constant_pull(200.0, gap);
    m.pull.beyond = fall();
  });
  const LumpedResult result = simulate_fast(problem);
  const double area = 200.0 * gap * problem.sphere.radius() / 3.0;
  EXPECT_NEAR(0.5 * 0.0896 * 225.0 - energy_left(result), area, 1e-4 * area);
  // Contact ends where the pull does.
  EXPECT_NEAR(result.trace.deflection.back(), -gap * problem.sphere.radius(), 1e-9);
  EXPECT_NEAR(result.trace.force.back(), 0.0, 1e-6);
  EXPECT_LT(result.closures.energy, 1e-8);
}

// A further pull P (1 − √(x/x_m)) on the way back takes ∫ = P x_m/3.
TEST(PullCurvesTest, WhatIsPulledOnTheWayBackAloneIsTaken) {
  const auto result = simulate_fast(with(elastic_problem(), [](Mechanisms& m) {
    m.pull = constant_pull(0.0, 0.0);
    for (std::size_t k = 0; k < FactorCurve::points; ++k)
      m.pull.unloading.value[k] = newtons(300.0) * (1.0 - 0.2 * static_cast<double>(k));
  }));
  const double taken = 300.0 * result.scalars.peak_deflection / 3.0;
  EXPECT_NEAR(0.5 * 0.0896 * 225.0 - energy_left(result), taken, 1e-3 * taken);
}

TEST(PullCurvesTest, CvodeSaysTheSame) {
  const auto problem = with(elastic_problem(), [](Mechanisms& m) {
    m.pull = constant_pull(200.0, 0.05);
    m.pull.beyond = fall();
  });
  const ImpactScalars fast = simulate_fast(problem).scalars, slow = simulate(problem).scalars;
  EXPECT_NEAR(fast.restitution, slow.restitution, 1e-6);
  EXPECT_NEAR(fast.contact_time / slow.contact_time, 1.0, 1e-5);
}

TEST(PullCurvesTest, ABallThatIsHeldHasNoRestitution) {
  auto problem = with(elastic_problem(), [](Mechanisms& m) {
    m.pull = constant_pull(500.0, 0.5);
    m.pull.beyond = fall();
  });
  problem.impact.speed = 1.0;
  for (auto run : {simulate, simulate_fast}) EXPECT_THROW(run(problem), Error);
}

// Pulled back again and again without loss: hundreds of touches, each found by trial.
TEST(PullCurvesTest, ABallThatIsHeldAndBouncesIsGivenUp) {
  auto problem = with(elastic_problem(), [](Mechanisms& m) {
    m.pull = constant_pull(500.0, 0.5);
    m.pull.beyond = fall();
  });
  problem.impact.speed = 3.0;
  try {
    simulate_fast(problem);
    FAIL() << "it came away";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::solver_failed);
    EXPECT_NE(std::string(error.what()).find("chatters"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace rebound
