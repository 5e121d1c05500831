#include "comparisons/discrepancy/diagnosis/missing_force/driven_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/missing_force/first_touch.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_samples.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

LumpedProblem relaxing_impact() {
  LumpedProblem problem{
      .sphere = {.mass = 89.6e-3, .diameter = 66.2e-3},
      .impact = {.speed = 12.0},
      .model = {.parameters = {{"exponent", 1.5}, {"stiffness", 3.2e6}, {"damping", 5e4}}},
      .controls = {.relative_tolerance = 1e-9, .samples = 801}};
  problem.model.mechanisms.relaxation = {.ratio = 0.3, .relaxation_time = 3e-4};
  return problem;
}

double peak_of(const Trace& trace) {
  return *std::max_element(trace.force.begin(), trace.force.end());
}

TEST(DrivenContactTest, FollowsTheImpactItWasDrivenBy) {
  const LumpedProblem problem = relaxing_impact();
  const Trace impact = simulate_fast(problem).trace;
  DrivenContact contact(problem);
  const double impact_depth = *std::max_element(impact.deflection.begin(), impact.deflection.end());
  double velocity = problem.impact.speed;
  for (std::size_t i = 1; i + 1 < impact.time.size(); ++i) {
    const double step = impact.time[i] - impact.time[i - 1];
    velocity -= 0.5 * step * (impact.force[i] + impact.force[i - 1]) / problem.sphere.mass;
    contact.advance_to(velocity, step);
    ASSERT_NEAR(contact.force(), impact.force[i], 1e-4 * peak_of(impact)) << i;
    // Trapezia over 800 steps: (π h/T)²/12 of the largest deflection is 1.3e-6 of it.
    ASSERT_NEAR(contact.deflection(), impact.deflection[i], 3e-6 * impact_depth) << i;
  }
}

TEST(DrivenContactTest, WithNothingBesideItIsTheImpact) {
  const LumpedProblem problem = relaxing_impact();
  const LumpedResult impact = simulate_fast(problem);
  const Trace free = impact_with(problem, {[](double, double) { return 0.0; },
                                           [](double x, double v) { return v < 0.0 && x < 0.0; }});
  EXPECT_NEAR(peak_of(free), impact.scalars.peak_force, 1e-5 * impact.scalars.peak_force);
}

TEST(DrivenContactTest, AStiffnessBesideItIsThatOfAStifferLaw) {
  LumpedProblem stiffer = relaxing_impact();
  stiffer.model.mechanisms.relaxation = {};
  const LumpedProblem problem = stiffer;
  stiffer.model.parameters["stiffness"] *= 1.1;
  const double added = stiffer.model.parameters["stiffness"] - 3.2e6;
  const Trace free = impact_with(
      problem, {[&](double x, double) { return x > 0.0 ? added * x * std::sqrt(x) : 0.0; },
                [](double x, double v) { return v < 0.0 && x <= 0.0; }});
  const LumpedResult impact = simulate_fast(stiffer);
  EXPECT_NEAR(peak_of(free), impact.scalars.peak_force, 1e-4 * impact.scalars.peak_force);
}

TEST(ForceSamplesTest, ASpringAnswersASteadyForceByACosine) {
  constexpr double mass = 0.1, stiffness = 1e6, steady = 3.0, step = 1e-6;
  constexpr int count = 1500;  // three quarters of a period
  ForceSamples samples{.mass = mass};
  for (int i = 0; i < count; ++i) {
    samples.since_touch.push_back(step * i);
    samples.by_deflection.push_back(stiffness);
    samples.by_velocity.push_back(0.0);
  }
  Eigen::MatrixXd column = Eigen::MatrixXd::Constant(count, 1, steady);
  respond(samples, column);
  const double frequency = std::sqrt(stiffness / mass);
  for (int i = 0; i < count; i += 50)
    EXPECT_NEAR(column(i, 0), steady * std::cos(frequency * step * i), 0.01 * steady) << i;
}

TEST(FirstTouchTest, IsThatOfAHertzContact) {
  LumpedProblem problem = relaxing_impact();
  problem.model.mechanisms.relaxation = {};
  const LumpedResult impact = simulate_fast(problem);
  MeasuredImpact measured{.noise = {.deviation = 1e-3 * impact.scalars.peak_force}};
  const double step = impact.scalars.contact_time / 300.0, start = 40.3 * step;
  for (double t = 0.0; t < start + 1.2 * impact.scalars.contact_time; t += step) {
    const auto after =
        std::lower_bound(impact.trace.time.begin(), impact.trace.time.end(), t - start);
    const bool in_contact = t >= start && after != impact.trace.time.end();
    measured.trace.time.push_back(t);
    measured.trace.force.push_back(
        in_contact ? impact.trace.force[static_cast<std::size_t>(after - impact.trace.time.begin())]
                   : 0.0);
  }
  const FirstTouch touch = first_touch_of(measured, 0.0, impact.scalars.contact_time);
  EXPECT_NEAR(touch.time, start, 0.01 * impact.scalars.contact_time);
  EXPECT_LT(touch.deviation, 0.04 * impact.scalars.contact_time);
}

}  // namespace
}  // namespace rebound
