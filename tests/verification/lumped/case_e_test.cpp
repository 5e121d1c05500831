// Case e: a standard linear solid (instantaneous 20, long-term 10 MPa, τ 1 ms,
// ν 0.4, R 33.1 mm, m 89.6 g) on a rigid plate, by Lee–Radok and Ting. Targets:
// Ting's integral equations solved separately; impacts by another foundation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/accuracy/verification/lumped_cases.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/integration/foundation_impact.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331, mass = 0.0896;
const double stiffness = 4.0 / 3.0 * 10e6 / (1.0 - 0.16) * std::sqrt(radius);
const StandardLinearSphere solid{
    .stiffness = stiffness, .ratio = 1.0, .relaxation_time = 1e-3, .radius = radius};

TEST(VerificationCaseE, PathsAndImpactsAtSixSpeeds) {
  test::expect_rows(verify_viscoelastic_contact(), 32);
}

TEST(FoundationTest, WithoutBranchIsHertz) {
  const StandardLinearSphere elastic{
      .stiffness = stiffness, .ratio = 0.0, .relaxation_time = 1.0, .radius = radius};
  const auto impact = foundation_impact(elastic, {.mass = mass, .speed = 1.0});
  const auto hertz = elastic_impact({.stiffness = stiffness, .damping = 0.0}, {mass, 1.0});
  EXPECT_NEAR(impact.restitution, 1.0, 3e-4);
  EXPECT_NEAR(impact.peak_force / hertz.peak_force, 1.0, 3e-4);
  EXPECT_NEAR(impact.contact_time / hertz.contact_time, 1.0, 2e-3);
}

struct Rebound {
  double restitution = 0.0, contact_time = 0.0;
};

/// m ẍ = −F, F = κ x^1.5 + q, q̇ = κ (x^1.5)˙ − q/τ by the classical Runge–Kutta method from
/// touch to F = 0: shares nothing with the integrators of the program. Below a millionth of the
/// radius the step is even smaller, since the force starts as x^1.5.
Rebound one_state_on_hertz(double speed) {
  using State = std::array<double, 3>;  // x, ẋ, q
  const auto force = [](const State& s) {
    return stiffness * std::pow(std::max(s[0], 0.0), 1.5) + s[2];
  };
  const auto rate = [&](const State& s) {
    const double root = std::sqrt(std::max(s[0], 0.0));
    return State{s[1], -force(s) / mass, 1.5 * stiffness * root * s[1] - s[2] / 1e-3};
  };
  const auto moved = [](const State& s, double step, const State& by) {
    return State{s[0] + step * by[0], s[1] + step * by[1], s[2] + step * by[2]};
  };
  State s = {0.0, speed, 0.0};
  double time = 0.0;
  for (double step = 1e-9;; step = s[0] < 1e-6 * radius ? 1e-9 : 1e-7) {
    const State a = rate(s), b = rate(moved(s, 0.5 * step, a)), c = rate(moved(s, 0.5 * step, b)),
                d = rate(moved(s, step, c));
    State next = s;
    for (int i = 0; i < 3; ++i) next[i] += step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]);
    const double before = force(s), after = force(next);
    if (time > 0.0 && after <= 0.0) {
      const double share = before / (before - after);
      return {-(s[1] + share * (next[1] - s[1])) / speed, time + share * step};
    }
    s = next;
    time += step;
  }
}

// One internal state on the whole Hertz force is Lee–Radok while the contact
// grows: peak force and deflection are those of the table. It keeps memory of
// area that has let go, and so loses more while it shrinks and lets go sooner:
// by how much, the same equations integrated here say.
TEST(VerificationCaseE, TheLawIsExactWhileTheContactGrows) {
  for (const auto& [v, e, t, f, h, h_end] : targets::viscoelastic_impacts) {
    LumpedProblem problem;
    problem.sphere = {.mass = mass, .diameter = 2.0 * radius};
    problem.impact = {.speed = v, .separation = SeparationRule::zero_force};
    problem.model.law = "standard-linear-solid";
    problem.model.parameters = {
        {"stiffness", stiffness}, {"ratio", 1.0}, {"relaxation_time", 1e-3}};
    const auto scalars = simulate(problem).scalars;
    EXPECT_NEAR(scalars.peak_force / f, 1.0, 1e-5) << v;
    EXPECT_NEAR(scalars.peak_deflection / h, 1.0, 1e-5) << v;
    const Rebound expected = one_state_on_hertz(v);
    EXPECT_NEAR(scalars.restitution, expected.restitution, 1e-6) << v;
    EXPECT_NEAR(scalars.contact_time / expected.contact_time, 1.0, 1e-5) << v;
    EXPECT_LT(scalars.restitution, e) << v;
    EXPECT_LT(scalars.contact_time, t) << v;
  }
}

}  // namespace
}  // namespace rebound
