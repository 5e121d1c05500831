// The two integrators against each other, and what both must refuse.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lumped/integration/fast/dormand_prince.hpp"
#include "lumped/integration/fast/eighth_order_step.hpp"
#include "lumped/integration/fast/septic.hpp"
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

// The oscillator over a unit of time; the quadrature of its velocity is its displacement.
using Oscillator = EighthOrderStep<2, 1>;

Oscillator::Slope oscillate(const Oscillator::State& y) {
  return {{y[1], -y[0]}, {y[1]}};
}

TEST(EighthOrderStepTest, ObservedOrder) {
  const auto error_with = [](int steps) {
    Oscillator step;
    Oscillator::State y = {0.0, 1.0};
    for (int i = 0; i < steps; ++i) {
      step.take(oscillate, y, oscillate(y), 1.0 / steps);
      y = step.y;
    }
    return std::abs(y[0] - std::sin(1.0));
  };
  EXPECT_NEAR(std::log2(error_with(1) / error_with(2)), 8.0, 0.5);
}

TEST(EighthOrderStepTest, QuadratureOfTheSlopeIsTheState) {
  Oscillator step;
  const Oscillator::State start = {0.3, 1.0};
  step.take(oscillate, start, oscillate(start), 0.7);
  EXPECT_NEAR(start[0] + step.gained[0], step.y[0], 1e-15);
  EXPECT_NEAR(step.gained_error5[0], step.error5[0], 1e-15);
  EXPECT_NEAR(step.gained_error3[0], step.error3[0], 1e-15);
}

// Embedded errors fall with the sixth and fourth power of the step.
TEST(EighthOrderStepTest, EmbeddedErrorsHaveTheirOrder) {
  const auto errors = [](double h) {
    Oscillator step;
    const Oscillator::State start = {0.3, 1.0};
    step.take(oscillate, start, oscillate(start), h);
    return std::pair{std::hypot(step.error5[0], step.error5[1]),
                     std::hypot(step.error3[0], step.error3[1])};
  };
  const auto [five, three] = errors(0.4);
  const auto [five_half, three_half] = errors(0.2);
  EXPECT_NEAR(std::log2(five / five_half), 6.0, 0.5);
  EXPECT_NEAR(std::log2(three / three_half), 4.0, 0.5);
}

TEST(SepticTest, ReproducesSeventhDegree) {
  // Σ (k+1) (−1)ᵏ xᵏ and its derivatives.
  const auto derivative = [](int order, double x) {
    double sum = 0.0;
    for (int k = order; k <= 7; ++k) {
      double factor = (k % 2 ? -1.0 : 1.0) * (k + 1);
      for (int j = 0; j < order; ++j) factor *= k - j;
      sum += factor * std::pow(x, k - order);
    }
    return sum;
  };
  const auto end_at = [&](double x) {
    return HermiteEnd{derivative(0, x), derivative(1, x), derivative(2, x), derivative(3, x)};
  };
  const double a = 0.3, b = 1.1, h = b - a;
  const Septic path(end_at(a), end_at(b), h);
  for (double s : {0.0, 0.2, 0.7, 1.0}) {
    EXPECT_NEAR(path.value(s), derivative(0, a + s * h), 1e-12);
    EXPECT_NEAR(path.derivative(s) / h, derivative(1, a + s * h), 2e-12);
  }
}

// Samples lie between a few long steps: they are to be as good as the steps, whatever the
// tolerance, for laws with kinks at first touch too.
TEST(FastSamplesTest, AreAsGoodAsTheTolerance) {
  for (const auto& card : all_laws())
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection})
      for (double share : {1.0, 0.05}) {      // of the law's damping
        if (has_branch(card.name)) continue;  // composed: cubic between shorter steps
        LumpedProblem problem = test::typical_problem(card.name);
        problem.impact.separation = rule;
        problem.model.parameters[test::loss_parameter(card.name)] *= share;
        problem.controls.samples = 200;
        problem.controls.relative_tolerance = 1e-12;
        const LumpedResult exact = simulate_fast(problem);
        for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-9}) {
          problem.controls.relative_tolerance = tolerance;
          const LumpedResult run = simulate_fast(problem);
          SCOPED_TRACE(card.name + " at " + std::to_string(tolerance));
          EXPECT_LT(largest_difference(run.trace.force, exact.trace.force),
                    20.0 * tolerance * exact.scalars.peak_force);
          EXPECT_LT(largest_difference(run.trace.deflection, exact.trace.deflection),
                    20.0 * tolerance * exact.scalars.peak_deflection);
        }
      }
}

}  // namespace
}  // namespace rebound
