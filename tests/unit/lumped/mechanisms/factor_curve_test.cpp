#include "lumped/mechanisms/factor_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lumped/integration/simulate.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

TEST(FactorCurveTest, NothingIsOne) {
  EXPECT_EQ(curve_factor({}, 0.3), 1.0);
  for (const double u : {0.0, 0.11, 0.4, 2.0}) EXPECT_EQ(curve_factor({.end = 0.4}, u), 1.0);
}

TEST(FactorCurveTest, WhatIsNoNumberStaysNone) {
  EXPECT_TRUE(std::isnan(curve_factor({.end = 0.4}, std::nan(""))));
}

TEST(FactorCurveTest, GoesThroughItsPointsAndStaysBeyond) {
  const FactorCurve curve{.value = {0.1, -0.2, 0.3, 0.0, 0.5, -0.1}, .end = 0.5};
  for (std::size_t k = 0; k < FactorCurve::points; ++k)
    EXPECT_NEAR(curve_factor(curve, 0.1 * static_cast<double>(k)), 1.0 + curve.value[k], 1e-14);
  EXPECT_NEAR(curve_factor(curve, 3.0), 0.9, 1e-14);
}

TEST(FactorCurveTest, ALineStaysALine) {
  const FactorCurve line{.value = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}, .end = 0.5};
  for (double u = 0.0; u < 0.5; u += 0.013) EXPECT_NEAR(curve_factor(line, u), 1.0 + u, 1e-14);
}

TEST(FactorCurveTest, SlopesMeetAtThePoints) {
  const FactorCurve curve{.value = {0.1, -0.2, 0.3, 0.0, 0.5, -0.1}, .end = 1.0};
  constexpr double h = 1e-6;
  for (const double u : {0.2, 0.4, 0.6, 0.8}) {
    const double before = (curve_factor(curve, u) - curve_factor(curve, u - h)) / h;
    const double after = (curve_factor(curve, u + h) - curve_factor(curve, u)) / h;
    EXPECT_NEAR(before, after, 1e-3);
  }
}

// A straight curve over x/R is the stiffening 1 + b x/R, which has a formula of its own.
TEST(FactorCurveTest, AStraightElasticCurveIsStiffening) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.mechanisms.elastic.stiffening = 0.8;
  const LumpedResult by_formula = simulate(problem);
  problem.model.mechanisms.elastic = {};
  problem.model.mechanisms.elastic.curve = {.value = {0.0, 0.16, 0.32, 0.48, 0.64, 0.8},
                                            .end = 1.0};
  const LumpedResult by_curve = simulate(problem);
  EXPECT_NEAR(by_curve.scalars.peak_force / by_formula.scalars.peak_force, 1.0, 1e-8);
  EXPECT_NEAR(by_curve.scalars.restitution, by_formula.scalars.restitution, 1e-8);
  EXPECT_LT(by_curve.closures.energy, 1e-6);
}

/// e² of an elastic Hertz contact with F_max [s^1.5 − h √(1 − s)] on the way back, s = x/x_max: the
/// force ends at s₀^1.5 = h √(1 − s₀), and (5/2) ∫ from there to 1 is 1 − s₀^2.5 − (5/3) h (1 −
/// s₀)^1.5.
double energy_returned(double h) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double s = 0.5 * (low + high);
    (std::pow(s, 1.5) < h * std::sqrt(1.0 - s) ? low : high) = s;
  }
  return 1.0 - std::pow(low, 2.5) - 5.0 / 3.0 * h * std::pow(1.0 - low, 1.5);
}

// √(1 − s) is a line over u.
TEST(FactorCurveTest, ALineOfTheUnloadingLosesWhatItsIntegralSays) {
  constexpr double h = 0.15;
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters["damping"] = 0.0;
  problem.model.mechanisms.memory.curve = {
      .value = {-h, -0.8 * h, -0.6 * h, -0.4 * h, -0.2 * h, 0.0}, .end = 1.0};
  const LumpedResult result = simulate(problem);
  EXPECT_NEAR(std::pow(result.scalars.restitution, 2), energy_returned(h), 1e-6);
  EXPECT_LT(result.closures.energy, 1e-6);
}

// With q the loss grows as x_max^q over what it is at x_q.
TEST(FactorCurveTest, ALoopGrowsWithTheLargestDeflection) {
  constexpr double h = 0.1, q = 1.5;
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters["damping"] = 0.0;
  UnloadingMemory& memory = problem.model.mechanisms.memory;
  memory.curve = {.value = {-h, -0.8 * h, -0.6 * h, -0.4 * h, -0.2 * h, 0.0}, .end = 1.0};
  memory.curve_growth = q;
  memory.growth_deflection = 4e-3;
  const LumpedResult result = simulate(problem);
  const double grown = h * std::pow(result.scalars.peak_deflection / 4e-3, q);
  ASSERT_GT(std::abs(grown / h - 1.0), 0.1);
  ASSERT_LT(grown, 0.5);
  EXPECT_NEAR(std::pow(result.scalars.restitution, 2), energy_returned(grown), 1e-5);
  EXPECT_LT(result.closures.energy, 1e-6);
}

// Unloading of Walton and Braun, (1 + s) F_e(x) − s F_e(x_max), not below zero, is smooth over the
// deflection: a few points lose what it loses, to one in a hundred.
TEST(FactorCurveTest, AStiffUnloadingThatEndsEarlyIsACurve) {
  constexpr double s = 0.02;
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters["damping"] = 0.0;
  FactorCurve& curve = problem.model.mechanisms.memory.curve;
  curve.end = 1.0;
  for (std::size_t k = 0; k + 1 < FactorCurve::points; ++k)
    curve.value[k] = -s * (1.0 - std::pow(unloading_share(0.2 * static_cast<double>(k)), 1.5));
  const LumpedResult result = simulate(problem);
  // (1 + s) σ^1.5 = s where it ends; (5/2) ∫ of (1 + s) σ^1.5 − s from there.
  const double end = std::pow(s / (1.0 + s), 2.0 / 3.0);
  const double returned = (1.0 + s) * (1.0 - std::pow(end, 2.5)) - 2.5 * s * (1.0 - end);
  EXPECT_NEAR(std::pow(result.scalars.restitution, 2), returned, 0.01 * (1.0 - returned));
  EXPECT_LT(result.closures.energy, 1e-6);
}

// Over (x/R)^(1/4) a line is x^(1/4) ẋ, and a constant a dashpot.
TEST(FactorCurveTest, ALineOfDampingIsTsujis) {
  const LumpedProblem expected = test::typical_problem("tsuji");
  const double k = expected.model.parameters.at("stiffness");
  const double c = expected.model.parameters.at("damping");
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters = {{"stiffness", k}, {"damping", 0.0}};
  DampingFactors& damping = problem.model.mechanisms.damping;
  damping.rate_curve.end = 20.0;
  damping.added.end = 1.0;  // (x/R)^(1/4) = 1
  const double radius = problem.sphere.radius();
  const double unit = k * std::pow(radius, 1.5) / damping.rate_curve.end;
  const double at_end = c * std::pow(radius, 0.25) / unit;
  for (std::size_t i = 0; i < FactorCurve::points; ++i)
    damping.added.value[i] = 0.2 * static_cast<double>(i) * at_end;
  const LumpedResult by_law = simulate(expected), by_curve = simulate(problem);
  EXPECT_NEAR(by_curve.scalars.restitution, by_law.scalars.restitution, 1e-7);
  EXPECT_NEAR(by_curve.scalars.peak_force / by_law.scalars.peak_force, 1.0, 1e-7);

  problem.model.mechanisms.damping.added.value.fill(0.05);
  LumpedProblem dashpot = problem;
  dashpot.model.mechanisms.damping = {.dashpot = 0.05 * unit};
  const LumpedResult constant = simulate(problem), linear = simulate(dashpot);
  EXPECT_NEAR(constant.scalars.restitution, linear.scalars.restitution, 1e-7);
  EXPECT_LT(constant.closures.energy, 1e-6);
}

// Three equal branches are one of three times the ratio.
TEST(FactorCurveTest, BranchesOfOneTimeAdd) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.mechanisms.relaxation = {.ratio = 0.6, .relaxation_time = 4e-4};
  const LumpedResult one = simulate(problem);
  problem.model.mechanisms.relaxation.ratio = 0.2;
  problem.model.mechanisms.further_relaxation = {
      RelaxationBranch{.ratio = 0.2, .relaxation_time = 4e-4},
      RelaxationBranch{.ratio = 0.2, .relaxation_time = 4e-4}};
  const LumpedResult three = simulate(problem);
  EXPECT_NEAR(three.scalars.restitution, one.scalars.restitution, 1e-7);
  EXPECT_NEAR(three.scalars.peak_force / one.scalars.peak_force, 1.0, 1e-7);
}

}  // namespace
}  // namespace rebound
