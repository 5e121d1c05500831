// A plate, an inner mass and weight against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/mechanism_cases.hpp"

namespace rebound {
namespace {

using test::elastic_problem;
using test::hertz;
using test::stiffness;
using test::with;

TEST(MovingPlateTest, StiffPlateIsRigid) {
  const LumpedProblem plain = test::typical_problem("hunt-crossley");
  const auto stiff = with(plain, [](Mechanisms& m) { m.plate = {.stiffness = 1e11}; });
  const LumpedResult result = simulate_fast(stiff);
  EXPECT_NEAR(result.scalars.restitution, simulate_fast(plain).scalars.restitution, 1e-5);
  ASSERT_EQ(result.trace.further.size(), 2u);
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
  const auto free = with(elastic_problem(), [&](Mechanisms& m) {
    m.plate = {.stiffness = 1e-3, .mass = plate, .damping_ratio = 0.0};
  });
  const LumpedResult result = simulate_fast(free);
  const ElasticImpact relative = hertz(stiffness, reduced, 15.0);
  EXPECT_NEAR(result.scalars.contact_time / relative.contact_time, 1.0, 1e-6);
  EXPECT_NEAR(result.scalars.restitution, (plate - ball) / (plate + ball), 1e-6);
  const auto& force = result.trace.further.at(0).values;
  EXPECT_NEAR(*std::max_element(force.begin(), force.end()) / relative.peak_force, 1.0, 1e-4);
}

TEST(PlateFrameTest, AStiffFrameIsNone) {
  const auto on_floor = with(test::typical_problem("hunt-crossley"), [](Mechanisms& m) {
    m.plate = {.stiffness = 2e7, .mass = 1.0, .damping_ratio = 0.05};
  });
  const auto on_frame =
      with(on_floor, [](Mechanisms& m) { m.plate.frame = {.stiffness = 1e12, .mass = 5.0}; });
  test::expect_same_impact(on_floor, on_frame, 1e-4);
}

// A frame of no mass puts its spring behind that of the cell: 1/k = 1/k_cell + 1/k_frame.
TEST(PlateFrameTest, ALightFrameIsASpringInSeries) {
  const auto in_series = with(elastic_problem(), [](Mechanisms& m) {
    m.plate = {.stiffness = 1e7, .mass = 1.0, .damping_ratio = 0.0};
  });
  const auto on_frame = with(elastic_problem(), [](Mechanisms& m) {
    m.plate = {.stiffness = 2e7, .mass = 1.0, .damping_ratio = 0.0};
    m.plate.frame = {.stiffness = 2e7, .mass = 1e-4, .damping_ratio = 0.0};
  });
  test::expect_same_impact(in_series, on_frame, 1e-3);
}

TEST(PlateFrameTest, CvodeSaysTheSameAndEnergyIsKept) {
  const auto problem = with(test::typical_problem("hunt-crossley"), [](Mechanisms& m) {
    m.plate = {.stiffness = 2e7, .mass = 1.0, .damping_ratio = 0.05};
    m.plate.frame = {.stiffness = 3e7, .mass = 2.0, .damping_ratio = 0.1};
  });
  const LumpedResult fast = simulate_fast(problem), slow = simulate(problem);
  EXPECT_NEAR(fast.scalars.restitution, slow.scalars.restitution, 1e-6);
  EXPECT_NEAR(fast.scalars.peak_force / slow.scalars.peak_force, 1.0, 1e-5);
  EXPECT_LT(fast.closures.energy, 1e-7);
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

}  // namespace
}  // namespace rebound
