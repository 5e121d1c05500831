// Derivatives of an impact: the fast path, CVODES, closed forms and central differences.
#include "lumped/integration/sensitivities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

using Member = double ImpactOutcome::*;

const std::map<std::string, Member> outcomes = {
    {"restitution", &ImpactOutcome::restitution},
    {"contact time", &ImpactOutcome::contact_time},
    {"peak force", &ImpactOutcome::peak_force},
    {"peak deflection", &ImpactOutcome::peak_deflection}};

constexpr auto both_rules = {SeparationRule::zero_force, SeparationRule::zero_deflection};

double& value_of(LumpedProblem& problem, const std::string& name) {
  if (name == "mass") return problem.sphere.mass;
  if (name == "speed") return problem.impact.speed;
  return problem.model.parameters.at(name);
}

LumpedProblem problem_of(const std::string& law, SeparationRule rule, double tolerance) {
  LumpedProblem problem = test::typical_problem(law);
  problem.impact.separation = rule;
  problem.controls = {.relative_tolerance = tolerance, .samples = 101};
  // Away from a corner of the table of coefficients.
  if (problem.model.parameters.contains("poisson_ratio"))
    problem.model.parameters["poisson_ratio"] = 0.37;
  return problem;
}

/// Fourth-order central difference of f over a relative step.
template <class F>
double difference(const F& f, double at, double share) {
  const double h = share * at;
  return (8.0 * (f(at + h) - f(at - h)) - (f(at + 2.0 * h) - f(at - 2.0 * h))) / (12.0 * h);
}

class SensitivityBattery : public testing::TestWithParam<std::string> {};

// What counts is the change for a change of the parameter by its own size, over the outcome.
TEST_P(SensitivityBattery, FastPathAgreesWithCentralDifferences) {
  for (const auto rule : both_rules) {
    const LumpedProblem problem = problem_of(GetParam(), rule, 1e-11);
    const Sensitivities found = sensitivities_fast(problem);
    for (std::size_t i = 0; i < found.by.size(); ++i)
      for (const auto& [what, member] : outcomes) {
        LumpedProblem changed = problem;
        double& value = value_of(changed, found.by[i]);
        const double here = value;
        const double expected = difference(
            [&](double at) {
              value = at;
              return sensitivities_fast(changed).outcome.*member;
            },
            here, 2e-3);
        EXPECT_NEAR(found.slopes[i].*member * here, expected * here, 1e-7 * found.outcome.*member)
            << what << " by " << found.by[i];
      }
  }
}

// Errors of CVODE at 1e-11 in variables with square roots at both ends.
TEST_P(SensitivityBattery, FastPathAgreesWithCvodes) {
  for (const auto rule : both_rules) {
    LumpedProblem problem = problem_of(GetParam(), rule, 1e-11);
    const Sensitivities fast = sensitivities_fast(problem), cvodes = sensitivities(problem);
    ASSERT_EQ(fast.by, cvodes.by);
    for (std::size_t i = 0; i < fast.by.size(); ++i) {
      const double size = value_of(problem, fast.by[i]);
      for (const auto& [what, member] : outcomes) {
        EXPECT_NEAR(fast.outcome.*member / (cvodes.outcome.*member), 1.0, 1e-7) << what;
        EXPECT_NEAR(fast.slopes[i].*member * size, cvodes.slopes[i].*member * size,
                    1e-6 * fast.outcome.*member)
            << what << " by " << fast.by[i];
      }
      for (std::size_t k = 1; k + 1 < fast.time.size(); ++k)
        ASSERT_NEAR(fast.force_slopes[i][k] * size, cvodes.force_slopes[i][k] * size,
                    1e-6 * fast.outcome.peak_force)
            << "force by " << fast.by[i] << " at sample " << k;
    }
  }
}

// The outcome is that of the shared scalars, whose peaks are parabolas through samples.
TEST_P(SensitivityBattery, OutcomeIsThatOfTheTrace) {
  for (const auto rule : both_rules) {
    const LumpedProblem problem = problem_of(GetParam(), rule, 1e-9);
    const Sensitivities found = sensitivities_fast(problem);
    const LumpedResult run = simulate_fast(problem);
    EXPECT_NEAR(found.outcome.restitution, run.scalars.restitution, 1e-14);
    EXPECT_NEAR(found.outcome.contact_time / run.scalars.contact_time, 1.0, 1e-14);
    EXPECT_NEAR(found.outcome.peak_force / run.scalars.peak_force, 1.0, 1e-4);
    EXPECT_NEAR(found.outcome.peak_deflection / run.scalars.peak_deflection, 1.0, 1e-5);
    for (std::size_t k = 0; k < found.force.size(); ++k)
      ASSERT_NEAR(found.force[k], run.trace.force[k], 2e-8 * found.outcome.peak_force);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& card : all_laws())
    if (!has_branch(card.name)) all.push_back(card.name);
  return all;
}
std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(EveryLaw, SensitivityBattery, testing::ValuesIn(names()), test_name);

TEST(SensitivitiesTest, KelvinVoigtInClosedForm) {
  for (const auto rule : both_rules)
    for (const auto run : {sensitivities, sensitivities_fast}) {
      LumpedProblem problem = problem_of("linear-kelvin-voigt", rule, 1e-11);
      const Sensitivities found = run(problem);
      for (std::size_t i = 0; i < found.by.size(); ++i) {
        const double here = value_of(problem, found.by[i]);
        const auto impact_with = [&](double at) {
          LumpedProblem changed = problem;
          value_of(changed, found.by[i]) = at;
          return KelvinVoigtImpact({.stiffness = changed.model.parameters.at("stiffness"),
                                    .damping = changed.model.parameters.at("damping")},
                                   {.mass = changed.sphere.mass, .speed = changed.impact.speed});
        };
        const double e =
            difference([&](double at) { return impact_with(at).restitution(rule); }, here, 1e-3);
        const double t =
            difference([&](double at) { return impact_with(at).contact_time(rule); }, here, 1e-3);
        EXPECT_NEAR(found.slopes[i].restitution * here, e * here, 1e-8) << found.by[i];
        EXPECT_NEAR(found.slopes[i].contact_time * here, t * here,
                    1e-8 * found.outcome.contact_time)
            << found.by[i];
      }
    }
}

// p (1 + e) = ln[(1 + p)/(1 − p e)], p = λ v₀/κ; neither mass nor exponent counts.
TEST(SensitivitiesTest, HuntCrossleyInClosedForm) {
  for (const auto rule : both_rules)
    for (const auto run : {sensitivities, sensitivities_fast}) {
      const LumpedProblem problem = problem_of("hunt-crossley", rule, 1e-11);
      const Sensitivities found = run(problem);
      const double kappa = problem.model.parameters.at("stiffness");
      const double lambda = problem.model.parameters.at("damping");
      const double v = problem.impact.speed, p = lambda * v / kappa;
      const double e = hunt_crossley_restitution(p);
      const double by_p = (1.0 + e - 1.0 / (1.0 + p) - e / (1.0 - p * e)) / (p / (1.0 - p * e) - p);
      const std::map<std::string, double> expected = {{"exponent", 0.0},
                                                      {"stiffness", -by_p * p / kappa},
                                                      {"damping", by_p * v / kappa},
                                                      {"mass", 0.0},
                                                      {"speed", by_p * lambda / kappa}};
      for (std::size_t i = 0; i < found.by.size(); ++i) {
        LumpedProblem copy = problem;
        const double size = value_of(copy, found.by[i]);
        EXPECT_NEAR(found.slopes[i].restitution * size, expected.at(found.by[i]) * size, 3e-8)
            << found.by[i];
      }
    }
}

// Without loss the contact time of Hertz goes with (m/κ)^(2/5) v^(−1/5).
TEST(SensitivitiesTest, HertzScales) {
  LumpedProblem problem = problem_of("hunt-crossley", SeparationRule::zero_force, 1e-11);
  problem.model.parameters["damping"] = 0.0;
  const Sensitivities found = sensitivities_fast(problem);
  const std::map<std::string, double> power = {{"stiffness", -0.4}, {"mass", 0.4}, {"speed", -0.2}};
  for (std::size_t i = 0; i < found.by.size(); ++i) {
    if (!power.contains(found.by[i])) continue;
    EXPECT_NEAR(found.slopes[i].contact_time * value_of(problem, found.by[i]),
                power.at(found.by[i]) * found.outcome.contact_time,
                1e-8 * found.outcome.contact_time);
  }
}

TEST(SensitivitiesTest, RefusesMechanisms) {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.mechanisms.gravity = 9.81;
  for (const auto run : {sensitivities, sensitivities_fast}) EXPECT_THROW(run(problem), Error);
}

}  // namespace
}  // namespace rebound
