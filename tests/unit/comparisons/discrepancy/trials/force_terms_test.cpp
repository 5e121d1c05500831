#include "comparisons/discrepancy/trials/force_terms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

LumpedProblem impact_with(double stiffness, double damping) {
  LumpedProblem problem;
  problem.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3};
  problem.impact.speed = 15.0;
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", stiffness}, {"damping", damping}};
  return problem;
}

/// Force of an impact at these instants; zero after the contact.
std::vector<double> force_at(const Trace& impact, const std::vector<double>& instants) {
  std::vector<double> force;
  for (const double t : instants) {
    const auto above = std::upper_bound(impact.time.begin(), impact.time.end(), t);
    if (above == impact.time.begin() || above == impact.time.end()) {
      force.push_back(0.0);
      continue;
    }
    const auto i = static_cast<std::size_t>(above - impact.time.begin());
    const double share = (t - impact.time[i - 1]) / (impact.time[i] - impact.time[i - 1]);
    force.push_back(impact.force[i - 1] + share * (impact.force[i] - impact.force[i - 1]));
  }
  return force;
}

const ForceTerm& term_named(const std::string& name) {
  for (const ForceTerm& term : force_terms())
    if (term.name == name) return term;
  throw std::runtime_error("no term " + name);
}

/// Largest difference of two histories over the largest value of the second.
double largest_error(const std::vector<double>& found, const std::vector<double>& expected) {
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    error = std::max(error, std::abs(found[i] - expected[i]));
    largest = std::max(largest, std::abs(expected[i]));
  }
  return error / largest;
}

constexpr double stiffness = 3.2e6, damping = 7e4;

/// What a law with a little more of one number reads more, per newton of the term.
std::vector<double> difference(const LumpedProblem& more, const LumpedProblem& less,
                               const Trace& impact, double newtons) {
  const std::vector<double> above = force_at(simulate(more).trace, impact.time),
                            below = force_at(simulate(less).trace, impact.time);
  std::vector<double> change;
  for (std::size_t i = 0; i < above.size(); ++i) change.push_back((above[i] - below[i]) / newtons);
  return change;
}

TEST(ForceTermsTest, TheLawsOwnTermIsAChangeOfStiffness) {
  const LumpedProblem problem = impact_with(stiffness, damping);
  const Trace impact = simulate(problem).trace;
  const MotionScales scales{.deflection = 2e-3, .rate = 15.0};
  const double step = 1e-3 * stiffness;
  std::vector<double> expected =
      difference(impact_with(stiffness + step, damping), impact_with(stiffness - step, damping),
                 impact, 2.0 * step * std::pow(scales.deflection, 1.5));
  const std::vector<double> found = force_response(term_named("x^1.5"), problem, impact, scales);
  expected.resize(expected.size() - 10);  // the stiffer ball has left by then
  EXPECT_LT(largest_error(found, expected), 0.01);
}

TEST(ForceTermsTest, ASecondPowerIsAForceOfItsOwn) {
  // No law of the list has such a term: held against steps of the equation of motion itself.
  const LumpedProblem problem = impact_with(stiffness, 0.0);
  const Trace impact = simulate(problem).trace;
  const MotionScales scales{.deflection = impact.deflection[impact.deflection.size() / 2],
                            .rate = 15.0};
  const double newtons = 1.0, m = problem.sphere.mass;
  const auto force_with = [&](double share) {
    std::vector<double> force;
    double x = 0.0, v = 15.0;
    const auto at = [&](double y) {
      const double u = std::max(0.0, y);
      return stiffness * std::pow(u, 1.5) + share * newtons * std::pow(u / scales.deflection, 2.0);
    };
    constexpr int substeps = 50;  // velocity Verlet
    for (std::size_t i = 0; i < impact.time.size(); ++i) {
      force.push_back(at(x));
      if (i + 1 == impact.time.size()) break;
      const double h = (impact.time[i + 1] - impact.time[i]) / substeps;
      for (int k = 0; k < substeps; ++k) {
        const double half = v - 0.5 * h * at(x) / m;
        x += h * half;
        v = half - 0.5 * h * at(x) / m;
      }
    }
    return force;
  };
  const std::vector<double> above = force_with(1.0), below = force_with(-1.0);
  std::vector<double> expected;
  for (std::size_t i = 0; i < above.size(); ++i) expected.push_back((above[i] - below[i]) / 2.0);
  expected.resize(expected.size() - 10);  // one of the two has left by then
  EXPECT_LT(largest_error(force_response(term_named("x^2"), problem, impact, scales), expected),
            1e-3);
}

TEST(ForceTermsTest, RatesAreThoseOfTheMotion) {
  const Trace impact = simulate(impact_with(stiffness, damping)).trace;
  const std::vector<double> rates = deflection_rates(impact);
  EXPECT_NEAR(rates.front(), 15.0, 0.01);
  const double work = rates.back() / 15.0;
  EXPECT_LT(work, 0.0) << "the ball leaves";
  EXPECT_GT(work, -1.0) << "with less than it came";
}

}  // namespace
}  // namespace rebound
