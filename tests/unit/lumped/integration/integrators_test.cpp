// The two integrators against each other, and what both must refuse.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lumped/integration/dormand_prince.hpp"
#include "lumped/integration/quintic.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference;
}

// Both run at a local tolerance of 1e-9. CVODE takes some hundred steps in
// variables with square roots at both ends, so a thousand times the tolerance
// is allowed between the two, which share neither variables nor method.
TEST(IntegratorsTest, FastPathAgreesWithCvode) {
  for (const auto& card : all_laws()) {
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      for (double speed : {0.1, 5.0, 25.0}) {
        LumpedProblem problem = test::typical_problem(card.name);
        problem.impact = {.speed = speed, .separation = rule};
        const LumpedResult fast = simulate_fast(problem), cvode = simulate(problem);
        SCOPED_TRACE(card.name + " at " + std::to_string(speed));
        EXPECT_NEAR(fast.scalars.restitution, cvode.scalars.restitution, 1e-6);
        EXPECT_NEAR(fast.scalars.contact_time / cvode.scalars.contact_time, 1.0, 1e-6);
        EXPECT_NEAR(fast.scalars.contact_time_1pct / cvode.scalars.contact_time_1pct, 1.0, 1e-6);
        EXPECT_NEAR(fast.scalars.peak_force / cvode.scalars.peak_force, 1.0, 1e-6);
        EXPECT_NEAR(fast.scalars.peak_deflection / cvode.scalars.peak_deflection, 1.0, 1e-6);
        EXPECT_NEAR(fast.scalars.mean_deflection / cvode.scalars.mean_deflection, 1.0, 1e-6);
        EXPECT_LT(largest_difference(fast.trace.force, cvode.trace.force),
                  1e-6 * fast.scalars.peak_force);
        EXPECT_LT(largest_difference(fast.trace.deflection, cvode.trace.deflection),
                  1e-6 * fast.scalars.peak_deflection);
      }
    }
  }
}

TEST(IntegratorsTest, OverdampedContactDoesNotEndAtZeroDeflection) {
  LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
  problem.model.parameters["damping"] = 3.0 * 2.0 * std::sqrt(2.5e5 * 0.0896);  // ζ = 3
  problem.impact.separation = SeparationRule::zero_deflection;
  for (auto run : {simulate, simulate_fast}) {
    try {
      run(problem);
      FAIL() << "a restitution was reported";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::solver_failed);
    }
  }
  problem.impact.separation = SeparationRule::zero_force;
  EXPECT_NEAR(simulate(problem).scalars.restitution, simulate_fast(problem).scalars.restitution,
              1e-6);
}

TEST(IntegratorsTest, RefusesControlsOutOfRange) {
  for (auto run : {simulate, simulate_fast}) {
    LumpedProblem problem = test::typical_problem("hunt-crossley");
    for (double tolerance : {0.0, -1e-9, 1e-14, 0.1, std::nan("")}) {
      problem.controls = {.relative_tolerance = tolerance, .samples = 401};
      EXPECT_THROW(run(problem), Error) << tolerance;
    }
    for (int samples : {-1, 0, 2, 49}) {
      problem.controls = {.relative_tolerance = 1e-9, .samples = samples};
      EXPECT_THROW(run(problem), Error) << samples;
    }
  }
}

// Exponential growth across one unit of time: fifth order globally.
TEST(DormandPrinceTest, ObservedOrder) {
  const auto field = [](const std::array<double, 1>& y) { return y; };
  const auto error_with = [&](int steps) {
    DormandPrinceStep<1> step;
    std::array<double, 1> y = {1.0}, slope = field(y);
    for (int i = 0; i < steps; ++i) {
      step.take(field, y, slope, 1.0 / steps);
      y = step.y;
      slope = step.derivative;
    }
    return std::abs(y[0] - std::exp(1.0));
  };
  const double order = std::log2(error_with(8) / error_with(16));
  EXPECT_NEAR(order, 5.0, 0.2);
}

TEST(QuinticTest, ReproducesFifthDegree) {
  const auto value = [](double x) { return 1 + x * (2 + x * (-3 + x * (4 + x * (-5 + x * 6)))); };
  const auto slope = [](double x) { return 2 + x * (-6 + x * (12 + x * (-20 + x * 30))); };
  const auto curvature = [](double x) { return -6 + x * (24 + x * (-60 + x * 120)); };
  const double a = 0.3, b = 1.1, h = b - a;
  const Quintic q({value(a), slope(a), curvature(a)}, {value(b), slope(b), curvature(b)}, h);
  for (double s : {0.0, 0.2, 0.7, 1.0}) {
    EXPECT_NEAR(q.value(s), value(a + s * h), 1e-14);
    EXPECT_NEAR(q.derivative(s) / h, slope(a + s * h), 1e-13);
  }
}

}  // namespace
}  // namespace rebound
