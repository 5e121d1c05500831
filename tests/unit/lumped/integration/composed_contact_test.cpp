// Composed contacts against the bare law, and their force over deflection.
#include "lumped/integration/composed/composed_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/composed/composed_cvode.hpp"
#include "lumped/integration/composed/composed_integrator.hpp"
#include "lumped/integration/force_deflection.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

// Composed of nothing, by its own integrators, it is the law alone.
TEST(ComposedContactTest, NothingIsTheBareLaw) {
  for (const LawCard& card : all_laws())
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      SCOPED_TRACE(card.name);
      LumpedProblem problem = test::typical_problem(card.name);
      problem.impact.separation = rule;
      const LumpedResult bare = simulate_fast(problem);
      const ComposedContact contact(problem);
      ComposedIntegrator fast(contact);
      ComposedCvode cvode(contact);
      for (const ComposedEnd& end : {fast.integrate(), cvode.integrate()}) {
        EXPECT_NEAR(end.time / bare.scalars.contact_time, 1.0, 1e-6);
        EXPECT_NEAR(-end.state[ComposedContact::velocity], bare.scalars.rebound_speed, 1e-5);
      }
      const Trace trace = fast.sample(problem.controls);
      EXPECT_TRUE(trace.further.empty());
      for (std::size_t i = 0; i < trace.time.size(); ++i)
        EXPECT_NEAR(trace.force[i], bare.trace.force[i], 1e-5 * bare.scalars.peak_force);
    }
}

// Memory of steps goes from one integrator to the next, not to one that runs beside it.
TEST(ComposedContactTest, AnotherIntegratorLeavesTheStepsOfThisOne) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.mechanisms.plate.stiffness = 5e7;
  const ComposedContact contact(problem);
  ComposedIntegrator first(contact);
  first.integrate();
  const Trace before = first.sample(problem.controls);
  problem.impact.speed *= 2.0;
  const ComposedContact faster(problem);
  ComposedIntegrator(faster).integrate();
  ComposedIntegrator second(faster);
  second.integrate();
  EXPECT_EQ(first.sample(problem.controls).force, before.force);
  EXPECT_NE(second.sample(problem.controls).force, before.force);
}

TEST(ComposedContactTest, ForcesAtFollowTheTrace) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.mechanisms.relaxation = {.ratio = 0.3, .relaxation_time = 1e-3};
  problem.model.mechanisms.memory.permanent_set = 0.05;
  const LumpedResult run = simulate_fast(problem);
  const DeflectionPoints points = deflection_points(run.trace);
  const std::vector<double> forces = forces_at(problem, points);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    // dF/dx has no bound at the turning point of a damped law.
    if (points.deflection[i] > 0.999 * run.scalars.peak_deflection) continue;
    EXPECT_NEAR(forces[i], run.trace.force[i], 1e-6 * run.scalars.peak_force) << i;
  }
  // Continuous whatever is asked: beyond the deepest point and before the open end.
  const auto odd =
      forces_at(problem, {{1.0, 0.0, -1.0}, {Branch::loading, Branch::unloading, Branch::loading}});
  EXPECT_NEAR(odd[0], forces_at(problem, {{run.scalars.peak_deflection}, {Branch::loading}})[0],
              1e-2 * run.scalars.peak_force);
  EXPECT_NEAR(odd[1], run.trace.force.back(), 1e-6 * run.scalars.peak_force);
  EXPECT_EQ(odd[2], run.trace.force.front());
}

// Halving the tolerance digits shows what a result at the default is worth.
TEST(ComposedContactTest, ConvergesWithTheTolerance) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  Mechanisms& m = problem.model.mechanisms;
  m.relaxation = {.ratio = 0.3, .relaxation_time = 1e-3};
  m.memory = {.hysteresis = 0.1, .permanent_set = 0.05};
  m.plate.stiffness = 5e7;
  m.adhesion = 20.0;
  problem.controls.relative_tolerance = 1e-13;
  const double exact = simulate_fast(problem).scalars.restitution;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    problem.controls.relative_tolerance = tolerance;
    EXPECT_NEAR(simulate_fast(problem).scalars.restitution, exact, 100.0 * tolerance);
  }
}

}  // namespace
}  // namespace rebound
