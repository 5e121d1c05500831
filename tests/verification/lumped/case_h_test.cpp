// Case h of the verification suite: the lumped integrators against closed
// forms and the exact Hunt–Crossley restitution; case f: Kuwabara–Kono.
//
// Tolerance. Both integrators run at a local relative tolerance of 1e-12.
// CVODE takes a few hundred steps in variables that have square roots at first
// touch; observed global errors stay below five hundred times the tolerance,
// so 1e-9 is asked of both. The closed forms themselves are held to 1e-12 in
// the unit tests.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

constexpr double bound = 1e-9;

LumpedProblem unit_problem(const std::string& law, double damping, SeparationRule rule) {
  LumpedProblem problem;
  problem.sphere = {.mass = 1.0, .diameter = 1.0};
  problem.impact = {.speed = 1.0, .separation = rule};
  problem.model = {.law = law,
                   .parameters = {{"stiffness", 1.0}, {"damping", damping}},
                   .restitution = {},
                   .damping_formula = "",
                   .at_speed = {}};
  problem.controls = {.relative_tolerance = 1e-12, .samples = 401};
  return problem;
}

constexpr auto both_rules = {SeparationRule::zero_force, SeparationRule::zero_deflection};

TEST(VerificationCaseH, HuntCrossleyRestitution) {
  for (const auto& [p, e] : targets::hunt_crossley)
    for (const auto rule : both_rules)
      for (auto run : {simulate, simulate_fast}) {
        const LumpedResult result = run(unit_problem("hunt-crossley", p, rule));
        EXPECT_NEAR(result.scalars.restitution, e, bound) << p;
        EXPECT_NEAR(result.scalars.restitution, hunt_crossley_restitution(p), bound) << p;
        const HuntCrossleyImpact exact({.stiffness = 1.0, .damping = p, .power = Power(1.5)},
                                       {.mass = 1.0, .speed = 1.0});
        EXPECT_NEAR(result.scalars.contact_time, exact.contact_time(), 5 * bound) << p;
        // Peaks come from 401 samples: the parabola's error is third order in 1/400.
        EXPECT_NEAR(result.scalars.peak_deflection / exact.peak_deflection(), 1.0, 1e-7) << p;
        EXPECT_NEAR(result.scalars.peak_force / exact.peak_force(), 1.0, 2e-6) << p;
      }
}

TEST(VerificationCaseH, HuntCrossleyRestitutionWhateverTheExponent) {
  for (double n : {1.0, 1.2, 2.0, 2.7})
    for (auto run : {simulate, simulate_fast}) {
      LumpedProblem problem = unit_problem("hunt-crossley", 0.8, SeparationRule::zero_force);
      problem.model.parameters["exponent"] = n;
      EXPECT_NEAR(run(problem).scalars.restitution, 0.64796742493272, bound) << n;
    }
}

TEST(VerificationCaseH, KelvinVoigtUnderBothRules) {
  for (double zeta : {0.01, 0.05, 0.1, 0.2, 0.5, 0.9})
    for (const auto rule : both_rules)
      for (auto run : {simulate, simulate_fast}) {
        const LumpedResult result = run(unit_problem("linear-kelvin-voigt", 2.0 * zeta, rule));
        const KelvinVoigtImpact exact({.stiffness = 1.0, .damping = 2.0 * zeta},
                                      {.mass = 1.0, .speed = 1.0});
        EXPECT_NEAR(result.scalars.restitution, exact.restitution(rule), bound) << zeta;
        EXPECT_NEAR(result.scalars.contact_time, exact.contact_time(rule), 10 * bound) << zeta;
        for (std::size_t i = 0; i < result.trace.time.size(); ++i) {
          const ContactState state = exact.at(result.trace.time[i]);
          ASSERT_NEAR(result.trace.deflection[i], state.deflection, 10 * bound);
          ASSERT_NEAR(result.trace.force[i], state.force, 10 * bound);
        }
      }
}

TEST(VerificationCaseF, KuwabaraKonoUnderBothRules) {
  for (const auto& [beta, e_x, t_x, e_f, t_f, x_f] : targets::kuwabara_kono)
    for (auto run : {simulate, simulate_fast}) {
      const auto x = run(unit_problem("hertz-damped", beta, SeparationRule::zero_deflection));
      EXPECT_NEAR(x.scalars.restitution, e_x, bound) << beta;
      EXPECT_NEAR(x.scalars.contact_time, t_x, 5e-8) << beta;
      const auto f = run(unit_problem("hertz-damped", beta, SeparationRule::zero_force));
      EXPECT_NEAR(f.scalars.restitution, e_f, bound) << beta;
      EXPECT_NEAR(f.scalars.contact_time, t_f, 5e-9) << beta;
      EXPECT_NEAR(f.trace.deflection.back(), x_f, 1e-8) << beta;
    }
}

TEST(KuwabaraKonoTest, SmallDampingFollowsTheSeries) {
  const double c1 = 1.1534488580952888;
  for (double beta : {1e-3, 3e-3, 1e-2}) {
    const auto run =
        simulate_fast(unit_problem("hertz-damped", beta, SeparationRule::zero_deflection));
    const double series = 1.0 - c1 * beta + 0.6 * c1 * c1 * beta * beta;
    EXPECT_NEAR(run.scalars.restitution, series, 0.55 * beta * beta * beta + bound);
  }
}

}  // namespace
}  // namespace rebound
