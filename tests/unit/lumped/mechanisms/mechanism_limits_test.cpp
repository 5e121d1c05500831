// Impacts with one mechanism against closed forms and against other laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

constexpr double stiffness = 3.5e6;

/// Hertz without loss: every loss seen is the mechanism's.
LumpedProblem elastic_problem() {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters["stiffness"] = stiffness;
  problem.model.parameters["damping"] = 0.0;
  return problem;
}

template <class Edit>
LumpedProblem with(LumpedProblem problem, const Edit& edit) {
  edit(problem.model.mechanisms);
  return problem;
}

ElasticImpact hertz(double k, double mass, double speed) {
  return elastic_impact({.stiffness = k, .damping = 0.0, .power = Power(1.5)},
                        {.mass = mass, .speed = speed});
}

void expect_same_impact(const LumpedProblem& a, const LumpedProblem& b, double tolerance) {
  const ImpactScalars one = simulate_fast(a).scalars, other = simulate_fast(b).scalars;
  EXPECT_NEAR(one.restitution / other.restitution, 1.0, tolerance);
  EXPECT_NEAR(one.contact_time / other.contact_time, 1.0, tolerance);
  EXPECT_NEAR(one.peak_force / other.peak_force, 1.0, tolerance);
  EXPECT_NEAR(one.peak_deflection / other.peak_deflection, 1.0, tolerance);
}

TEST(RelaxationTest, SlowBranchIsStiffness) {
  const auto slow = with(test::typical_problem("hunt-crossley"),
                         [](Mechanisms& m) { m.relaxation = {.ratio = 0.3, .relaxation_time = 1e7}; });
  LumpedProblem stiffer = test::typical_problem("hunt-crossley");
  stiffer.model.parameters["stiffness"] *= 1.3;
  expect_same_impact(slow, stiffer, 1e-5);
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

// The relaxed part of the force is missing on the way back.
TEST(RelaxationTest, ForceEndsWhileTheBallIsStillDented) {
  const auto result = simulate_fast(
      with(elastic_problem(), [](Mechanisms& m) { m.relaxation = {0.3, 1e-3}; }));
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
    EXPECT_NEAR(result.scalars.contact_time,
                0.5 * bare.contact_time * (1.0 + std::sqrt(1.0 - set)), 1e-7 * bare.contact_time);
  }
}

// ∫ x^1.5 [1 − s (1 − x/x_m)] dx gives e² = 1 − s (1 − (5/2)/(7/2)).
TEST(HysteresisTest, LosesTheAreaOfItsLoop) {
  for (const double share : {0.1, 0.5, 1.0}) {
    const auto result = simulate_fast(
        with(elastic_problem(), [&](Mechanisms& m) { m.memory.hysteresis = share; }));
    EXPECT_NEAR(result.scalars.restitution, std::sqrt(1.0 - share * 2.0 / 7.0), 1e-7);
  }
}

TEST(AdhesionTest, EndsAtPullOff) {
  constexpr double work = 30.0;
  const auto sticky = with(elastic_problem(), [&](Mechanisms& m) { m.adhesion = work; });
  const LumpedResult result = simulate_fast(sticky);
  const double pull_off = 2.0 * std::numbers::pi * sticky.sphere.radius() * work;
  EXPECT_NEAR(result.trace.force.back(), -pull_off, 1e-6 * pull_off);
  EXPECT_NEAR(result.trace.deflection.back(), 0.0, 1e-9);
  EXPECT_LT(result.scalars.restitution, 1.0);
  // At most the pull times the deflection over which it grows: 0.01^(2/3) of the largest.
  const double lost = 0.5 * 0.0896 * 225.0 * (1.0 - std::pow(result.scalars.restitution, 2));
  EXPECT_LT(lost, pull_off * std::pow(0.01, 2.0 / 3.0) * 1.1 * result.scalars.peak_deflection);
  const auto hardly = with(elastic_problem(), [](Mechanisms& m) { m.adhesion = 1e-9; });
  EXPECT_NEAR(simulate_fast(hardly).scalars.restitution, 1.0, 1e-8);
}

TEST(AdhesionTest, ABallThatSticksHasNoRestitution) {
  auto problem = with(test::typical_problem("hunt-crossley"),
                      [](Mechanisms& m) { m.adhesion = 2e4; });
  problem.impact.speed = 0.5;
  for (auto run : {simulate, simulate_fast}) EXPECT_THROW(run(problem), Error);
}

TEST(MovingPlateTest, StiffPlateIsRigid) {
  const LumpedProblem plain = test::typical_problem("hunt-crossley");
  const auto stiff = with(plain, [](Mechanisms& m) { m.plate = {.stiffness = 1e11}; });
  const LumpedResult result = simulate_fast(stiff);
  EXPECT_NEAR(result.scalars.restitution, simulate_fast(plain).scalars.restitution, 1e-5);
  ASSERT_EQ(result.trace.further.size(), 1u);
  EXPECT_EQ(result.trace.further[0].name, "contact_force_N");
  const auto& contact = result.trace.further[0].values;
  for (std::size_t i = 0; i < contact.size(); ++i)
    EXPECT_NEAR(result.trace.force[i], contact[i], 5e-3 * result.scalars.peak_force);
}

// Two free bodies: relative motion is that of the reduced mass, and each
// parts with its share of the impulse.
TEST(MovingPlateTest, FreePlateIsTwoBodies) {
  constexpr double ball = 0.0896, plate = 0.7;
  const double reduced = ball * plate / (ball + plate);
  const auto free = with(elastic_problem(),
                         [&](Mechanisms& m) { m.plate = {.stiffness = 1e-3, .mass = plate, .damping_ratio = 0.0}; });
  const LumpedResult result = simulate_fast(free);
  const ElasticImpact relative = hertz(stiffness, reduced, 15.0);
  EXPECT_NEAR(result.scalars.contact_time / relative.contact_time, 1.0, 1e-6);
  EXPECT_NEAR(result.scalars.restitution, (plate - ball) / (plate + ball), 1e-6);
  const auto& force = result.trace.further.at(0).values;
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()) / relative.peak_force, 1.0, 1e-4);
}

// What the load cell reads is the spring and the damper, not the contact: its
// impulse is short of the ball's by the plate's momentum.
TEST(MovingPlateTest, LoadCellMissesThePlatesMomentum) {
  const auto problem = with(test::typical_problem("hunt-crossley"), [](Mechanisms& m) {
    m.plate = {.stiffness = 2e7, .mass = 1.0, .damping_ratio = 0.05};
  });
  LumpedProblem fine = problem;
  fine.controls.samples = 20001;
  const LumpedResult result = simulate_fast(fine);
  const auto impulse = [&](const std::vector<double>& force) {
    double sum = 0.0;
    for (std::size_t i = 1; i < force.size(); ++i)
      sum += 0.5 * (force[i] + force[i - 1]) * (result.trace.time[i] - result.trace.time[i - 1]);
    return sum;
  };
  const double ball = 0.0896 * (15.0 + result.scalars.rebound_speed);
  EXPECT_NEAR(impulse(result.trace.further[0].values) / ball, 1.0, 1e-6);
  EXPECT_GT(std::abs(impulse(result.trace.force) / ball - 1.0), 1e-3);
}

// A plate lighter than the ball strikes it again; the first parting is not the end.
TEST(MovingPlateTest, StrikesAgain) {
  const auto problem = with(elastic_problem(), [](Mechanisms& m) {
    m.plate = {.stiffness = 2e4, .mass = 0.01, .damping_ratio = 0.02};
  });
  const LumpedResult fast = simulate_fast(problem), cvode = simulate(problem);
  const auto& force = fast.trace.further[0].values;
  const auto apart = std::count(force.begin() + 1, force.end() - 1, 0.0);
  EXPECT_GT(apart, 10);
  EXPECT_LT(fast.closures.energy, 1e-6);
  EXPECT_LT(fast.closures.impulse, 1e-8);
  EXPECT_NEAR(fast.scalars.restitution, cvode.scalars.restitution, 1e-5);
  EXPECT_NEAR(fast.scalars.contact_time / cvode.scalars.contact_time, 1.0, 1e-5);
}

TEST(InternalModeTest, HighFrequencyIsOneMass) {
  const LumpedProblem plain = test::typical_problem("hunt-crossley");
  const auto stiff = with(plain, [](Mechanisms& m) { m.mode = {0.2, 2e5, 0.02}; });
  EXPECT_NEAR(simulate_fast(stiff).scalars.restitution, simulate_fast(plain).scalars.restitution,
              1e-4);
}

// A very slow mode leaves the outer mass alone in contact; the inner one
// flies on, and the centre of mass keeps its share of the speed.
TEST(InternalModeTest, LowFrequencyIsTheOuterMassAlone) {
  const auto soft = with(elastic_problem(), [](Mechanisms& m) { m.mode = {0.02, 1.0, 0.0}; });
  const ElasticImpact outer = hertz(stiffness, 0.98 * 0.0896, 15.0);
  const LumpedResult result = simulate_fast(soft);
  const double outer_rebound = 0.98 - 0.02;  // (1 − s) v₀ back, s v₀ on
  EXPECT_NEAR(result.scalars.restitution, outer_rebound, 1e-4);
  EXPECT_NEAR(result.scalars.contact_time / outer.contact_time, 1.0, 1e-3);
}

TEST(GravityTest, ASlowBallWeighsMore) {
  const double g = 9.80665;
  LumpedProblem plain = elastic_problem();
  plain.impact.speed = 0.1;
  const auto heavy = with(plain, [&](Mechanisms& m) { m.gravity = g; });
  const LumpedResult result = simulate_fast(heavy);
  // Energy at the turn: κ x^2.5/2.5 = m v²/2 + m g x.
  const double x = result.scalars.peak_deflection, m = plain.sphere.mass;
  EXPECT_NEAR(0.4 * stiffness * std::pow(x, 2.5) / (0.5 * m * 0.01 + m * g * x), 1.0, 1e-5);
  EXPECT_NEAR(result.scalars.restitution, 1.0, 1e-7);
}

// Heavily damped and hardly moving, the ball comes to rest on the plate: that
// is no impact with a restitution.
TEST(GravityTest, ABallThatComesToRestIsRefused) {
  LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
  problem.impact.speed = 1e-4;
  problem.model.mechanisms.gravity = 9.80665;
  EXPECT_THROW(simulate_fast(problem), Error);
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

// At a contact radius of R/5 and ν = 0.4 the force at a given centre-of-mass
// deflection is 20 % above Hertz, at 2R/5 46 %, where the first order gives 50 %.
TEST(FiniteSphereTest, ForceAboveHertz) {
  LumpedProblem problem = with(elastic_problem(), [](Mechanisms& m) { m.finite_sphere.share = 1.0; });
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
  LumpedProblem problem = with(elastic_problem(), [](Mechanisms& m) { m.finite_sphere.share = 1.0; });
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
