// Losses, adhesion, factors and the finite sphere against closed forms and other laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/mechanism_cases.hpp"

namespace rebound {
namespace {

using test::elastic_problem;
using test::expect_same_impact;
using test::hertz;
using test::stiffness;
using test::with;

TEST(RelaxationTest, SlowBranchIsStiffness) {
  const auto slow = with(test::typical_problem("hunt-crossley"), [](Mechanisms& m) {
    m.relaxation = {.ratio = 0.3, .relaxation_time = 1e7};
  });
  LumpedProblem stiffer = test::typical_problem("hunt-crossley");
  stiffer.model.parameters["stiffness"] *= 1.3;
  expect_same_impact(slow, stiffer, 1e-5);
}

// A slow branch of exponent -1/2 on Hertz's k x^1.5 is a linear spring s k sqrt(x_r) beside it: at
// the largest deflection  m v^2 / 2 = 2/5 k x^2.5 + s k sqrt(x_r) x^2 / 2.
TEST(RelaxationTest, AnExponentMakesTheSpringOfABranchLinear) {
  constexpr double ratio = 0.3;
  const LumpedProblem problem = with(elastic_problem(), [](Mechanisms& m) {
    m.relaxation = {.ratio = ratio, .relaxation_time = 1e7, .exponent = -0.5};
  });
  const LumpedResult result = simulate_fast(problem);
  const double x = result.scalars.peak_deflection;
  const double x_r = 0.1 * problem.sphere.radius();
  const double held =
      0.4 * stiffness * std::pow(x, 2.5) + 0.5 * ratio * stiffness * std::sqrt(x_r) * x * x;
  const double brought = 0.5 * problem.sphere.mass * std::pow(problem.impact.speed, 2);
  EXPECT_NEAR(held / brought, 1.0, 1e-5);
  EXPECT_NEAR(result.scalars.restitution, 1.0, 1e-4);
}

TEST(RelaxationTest, FastBranchIsNothing) {
  const LumpedProblem plain = test::typical_problem("hunt-crossley");
  double before = 1.0;
  for (const double time : {1e-5, 1e-6}) {  // the gap shrinks with τ
    const auto fast = with(plain, [&](Mechanisms& m) { m.relaxation = {0.3, time}; });
    const double gap = std::abs(simulate_fast(fast).scalars.restitution -
                                simulate_fast(plain).scalars.restitution);
    EXPECT_LT(gap, 0.15 * before);
    before = gap;
  }
  EXPECT_LT(before, 1e-3);
}

// On a linear spring, m x⃛ + m ẍ/τ + (1 + s) k ẋ + k x/τ = 0 with x = 0, ẋ = v₀,
// ẍ = 0 at first touch: three exponentials.
TEST(RelaxationTest, LinearSpringIsTheStandardLinearSolid) {
  using Complex = std::complex<double>;
  LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
  problem.model.parameters["damping"] = 0.0;
  problem.impact.separation = SeparationRule::zero_deflection;
  constexpr double ratio = 0.6, time = 4e-4;
  problem.model.mechanisms.relaxation = {.ratio = ratio, .relaxation_time = time};
  const double squared = problem.model.parameters["stiffness"] / problem.sphere.mass;
  // Durand–Kerner on the characteristic polynomial, in units of 1/τ.
  const double a = (1.0 + ratio) * squared * time * time, b = squared * time * time;
  std::array<Complex, 3> root = {Complex(1.0, 0.5), Complex(-0.7, 1.3), Complex(0.2, -1.1)};
  for (int sweep = 0; sweep < 200; ++sweep)
    for (int i = 0; i < 3; ++i) {
      const Complex r = root[i];
      root[i] -=
          (((r + 1.0) * r + a) * r + b) / ((r - root[(i + 1) % 3]) * (r - root[(i + 2) % 3]));
    }
  const Trace trace = simulate_fast(problem).trace;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    // x = v₀ τ Σ cᵢ e^{rᵢ t/τ} with Σ cᵢ = 0, Σ cᵢ rᵢ = 1, Σ cᵢ rᵢ² = 0.
    Complex x = 0.0;
    for (int k = 0; k < 3; ++k) {
      const Complex p = root[(k + 1) % 3], q = root[(k + 2) % 3];
      x -= (p + q) / ((root[k] - p) * (root[k] - q)) * std::exp(root[k] * trace.time[i] / time);
    }
    EXPECT_NEAR(trace.deflection[i], 15.0 * time * x.real(), 1e-9) << trace.time[i];
  }
}

// The relaxed part of the force is missing on the way back.
TEST(RelaxationTest, ForceEndsWhileTheBallIsStillDented) {
  const auto result = simulate_fast(with(elastic_problem(), [](Mechanisms& m) {
    m.relaxation = {0.3, 1e-3};
  }));
  EXPECT_NEAR(result.trace.force.back(), 0.0, 1e-6 * result.scalars.peak_force);
  EXPECT_GT(result.trace.deflection.back(), 0.01 * result.scalars.peak_deflection);
  EXPECT_LT(result.scalars.restitution, 0.99);
}

TEST(PermanentSetTest, LeavesItsShareOfTheLargestDeflection) {
  for (const double set : {0.02, 0.2, 0.6}) {
    const auto result = simulate_fast(
        with(elastic_problem(), [&](Mechanisms& m) { m.memory.permanent_set = set; }));
    EXPECT_NEAR(result.trace.deflection.back() / result.scalars.peak_deflection, set, 1e-6);
    EXPECT_NEAR(result.scalars.restitution, std::sqrt(1.0 - set), 1e-7);
    // Loading is the bare law's, unloading the same in time scaled by √(1 − p).
    const ElasticImpact bare = hertz(stiffness, 0.0896, 15.0);
    EXPECT_NEAR(result.scalars.contact_time, 0.5 * bare.contact_time * (1.0 + std::sqrt(1.0 - set)),
                1e-7 * bare.contact_time);
  }
}

// ∫ x^1.5 [1 − s (1 − x/x_m)] dx gives e² = 1 − s (1 − (5/2)/(7/2)).
TEST(HysteresisTest, LosesTheAreaOfItsLoop) {
  for (const double share : {0.1, 0.5, 1.0}) {
    const auto result =
        simulate_fast(with(elastic_problem(), [&](Mechanisms& m) { m.memory.hysteresis = share; }));
    EXPECT_NEAR(result.scalars.restitution, std::sqrt(1.0 - share * 2.0 / 7.0), 1e-7);
  }
}

TEST(AdhesionTest, PullsFromTouchToPullOffAndTakesNoEnergy) {
  constexpr double work = 30.0;
  const auto sticky = with(elastic_problem(), [&](Mechanisms& m) { m.adhesion = work; });
  const LumpedResult result = simulate_fast(sticky);
  const double pull_off = 2.0 * std::numbers::pi * sticky.sphere.radius() * work;
  EXPECT_NEAR(result.trace.force.back(), -pull_off, 1e-6 * pull_off);
  EXPECT_NEAR(result.trace.force.front(), -pull_off, 1e-6 * pull_off);
  EXPECT_NEAR(result.trace.deflection.back(), 0.0, 1e-9);
  EXPECT_NEAR(result.scalars.restitution, 1.0, 1e-8);
  const auto hardly = with(elastic_problem(), [](Mechanisms& m) { m.adhesion = 1e-9; });
  const double without = simulate_fast(elastic_problem()).scalars.peak_force;
  EXPECT_NEAR(simulate_fast(hardly).scalars.peak_force, without, 1e-8 * without);
}

TEST(AdhesionTest, ANeckTakesItsArea) {
  constexpr double work = 30.0, reach = 0.02;
  const auto sticky = with(elastic_problem(), [&](Mechanisms& m) {
    m.adhesion = work;
    m.adhesion_reach = reach;
  });
  const double radius = sticky.sphere.radius(), speed = sticky.impact.speed;
  const double taken = 2.0 * std::numbers::pi * radius * work * reach * radius / 3.0;
  const double brought = 0.5 * sticky.sphere.mass * speed * speed;
  for (auto run : {simulate, simulate_fast}) {
    const LumpedResult result = run(sticky);
    EXPECT_NEAR(result.scalars.restitution, std::sqrt(1.0 - taken / brought), 1e-7);
    EXPECT_NEAR(result.trace.deflection.back(), -reach * radius, 1e-6 * radius);
    EXPECT_NEAR(result.trace.force.back(), 0.0, 1e-3);
    EXPECT_LT(result.closures.energy, 1e-6);
  }
}

TEST(AdhesionTest, ABallThatSticksHasNoRestitution) {
  auto problem =
      with(test::typical_problem("hunt-crossley"), [](Mechanisms& m) { m.adhesion = 2e4; });
  problem.impact.speed = 0.5;
  for (auto run : {simulate, simulate_fast}) EXPECT_THROW(run(problem), Error);
}

TEST(DampingFactorTest, ADashpotBesideADashpotIsTheirSum) {
  LumpedProblem sum = test::typical_problem("linear-kelvin-voigt");
  sum.model.parameters["damping"] += 7.0;
  expect_same_impact(with(test::typical_problem("linear-kelvin-voigt"),
                          [](Mechanisms& m) { m.damping.dashpot = 7.0; }),
                     sum, 1e-6);
}

// κ x^1.5 (x/x_r)^−0.5 is a linear spring; λ x^1.5 ẋ (x/x_r)^−1.5 a linear dashpot.
TEST(DampingFactorTest, ExponentsTurnHuntCrossleyIntoKelvinVoigt) {
  const double x_r = 0.1 * 0.0331;
  LumpedProblem hunt_crossley = test::typical_problem("hunt-crossley");
  hunt_crossley.model.mechanisms.elastic.exponent = -0.5;
  hunt_crossley.model.mechanisms.damping.exponent = -1.5;
  LumpedProblem linear = test::typical_problem("linear-kelvin-voigt");
  const auto& values = hunt_crossley.model.parameters;
  linear.model.parameters = {{"stiffness", values.at("stiffness") * std::sqrt(x_r)},
                             {"damping", values.at("damping") * std::pow(x_r, 1.5)}};
  expect_same_impact(hunt_crossley, linear, 1e-5);
}

// Where the damping follows a power of the elastic force, it stays Hunt and Crossley's.
TEST(DampingFactorTest, WhatFollowsTheElasticForceStaysHuntCrossley) {
  const double x_r = 0.1 * 0.0331;
  LumpedProblem followed = test::typical_problem("hunt-crossley");
  followed.model.parameters["exponent"] = 1.5;
  followed.model.mechanisms.elastic.exponent = -0.3;
  followed.model.mechanisms.damping.elastic.exponent = -0.3;
  LumpedProblem softer = test::typical_problem("hunt-crossley");
  const auto& values = followed.model.parameters;
  softer.model.parameters = {{"exponent", 1.2},
                             {"stiffness", values.at("stiffness") * std::pow(x_r, 0.3)},
                             {"damping", values.at("damping") * std::pow(x_r, 0.3)}};
  expect_same_impact(followed, softer, 1e-5);
}

// At a contact radius of R/5 and ν = 0.4 the force at a given centre-of-mass
// deflection is 20 % above Hertz, at 2R/5 46 %, where the first order gives 50 %.
TEST(FiniteSphereTest, ForceAboveHertz) {
  LumpedProblem problem =
      with(elastic_problem(), [](Mechanisms& m) { m.finite_sphere.share = 1.0; });
  problem.controls.samples = 20001;
  problem.impact.speed = 25.0;
  const Trace trace = simulate_fast(problem).trace;
  const double radius = problem.sphere.radius();
  struct Published {
    double contact_radius, above, tolerance;
  };
  for (const auto& [contact_radius, above, tolerance] :
       {Published{0.2, 1.20, 0.01}, Published{0.4, 1.46, 0.05}}) {
    const double force = stiffness * std::pow(contact_radius * contact_radius * radius, 1.5);
    const auto i = static_cast<std::size_t>(
        std::lower_bound(trace.force.begin(), trace.force.begin() + 9000, force) -
        trace.force.begin());
    ASSERT_LT(i, 9000u);
    const double hertz_force = stiffness * std::pow(trace.deflection[i], 1.5);
    EXPECT_NEAR(trace.force[i] / hertz_force, above, tolerance);
  }
}

TEST(FiniteSphereTest, BeyondItsRangeIsAnError) {
  LumpedProblem problem =
      with(elastic_problem(), [](Mechanisms& m) { m.finite_sphere.share = 1.0; });
  problem.model.parameters["stiffness"] = 2e5;
  for (auto run : {simulate, simulate_fast}) {
    try {
      run(problem);
      FAIL() << "a result outside the range";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::solver_failed);
    }
  }
}

TEST(MechanismsTest, FrictionIsRefused) {
  const auto rubbing = with(elastic_problem(), [](Mechanisms& m) { m.plate.friction = 0.2; });
  for (auto run : {simulate, simulate_fast}) {
    try {
      run(rubbing);
      FAIL() << "friction was ignored";
    } catch (const Error& error) {
      EXPECT_EQ(error.location().key, "model.plate.friction");
    }
  }
}

}  // namespace
}  // namespace rebound
