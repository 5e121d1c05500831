#pragma once

#include <gtest/gtest.h>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"

/// Impacts on which one mechanism is seen alone.
namespace rebound::test {

inline constexpr double stiffness = 3.5e6;

/// Hertz without loss: every loss seen is the mechanism's.
inline LumpedProblem elastic_problem() {
  LumpedProblem problem = typical_problem("hunt-crossley");
  problem.model.parameters["stiffness"] = stiffness;
  problem.model.parameters["damping"] = 0.0;
  return problem;
}

template <class Edit>
LumpedProblem with(LumpedProblem problem, const Edit& edit) {
  edit(problem.model.mechanisms);
  return problem;
}

inline ElasticImpact hertz(double k, double mass, double speed) {
  return elastic_impact({.stiffness = k, .damping = 0.0, .power = Power(1.5)},
                        {.mass = mass, .speed = speed});
}

inline void expect_same_impact(const LumpedProblem& a, const LumpedProblem& b, double tolerance) {
  const ImpactScalars one = simulate_fast(a).scalars, other = simulate_fast(b).scalars;
  EXPECT_NEAR(one.restitution / other.restitution, 1.0, tolerance);
  EXPECT_NEAR(one.contact_time / other.contact_time, 1.0, tolerance);
  EXPECT_NEAR(one.peak_force / other.peak_force, 1.0, tolerance);
  EXPECT_NEAR(one.peak_deflection / other.peak_deflection, 1.0, tolerance);
}

}  // namespace rebound::test
