#include "comparisons/discrepancy/trials/generator/refit.hpp"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/discrepancy/trials/generator/example.hpp"

namespace trials::testing {
namespace {

constexpr double damping_number = 0.3;

/// Two shots of another ball, as the baseline gives them.
RefitProblem problem_of(const BaselineBall& truth, double gain) {
  RefitProblem problem{.ball = example_ball(damping_number),
                       .gain = 1.0,
                       .gain_uncertainty = 0.02,
                       .noise = {.deviation = 10.0},
                       .shots = {}};
  for (const double v : {5.0, 15.0}) {
    RefitShot shot{.time = {}, .force = {}, .speed = v, .speed_uncertainty = 0.01 * v};
    const BaselinePulse pulse(truth.damping * v);
    const PulseScales units = scales_of(truth, v);
    for (int i = -50; i < 300; ++i) {
      shot.time.push_back(i * 1e-5);
      shot.force.push_back(gain * units.force * pulse.force((i * 1e-5 - 3e-5) / units.time));
    }
    problem.shots.push_back(std::move(shot));
  }
  return problem;
}

TEST(TrialRefit, FindsAnotherBallAndStartTime) {
  BaselineBall other = example_ball(damping_number);
  other.stiffness *= 1.2;
  other.damping *= 0.7;
  const Refit fit = refit_baseline(problem_of(other, 1.0));
  EXPECT_LT(fit.chi_square, 1e-3);
  EXPECT_NEAR(fit.ball.stiffness / other.stiffness, 1.0, 1e-4);
  EXPECT_NEAR(fit.ball.damping / other.damping, 1.0, 1e-3);
}

TEST(TrialRefit, AGainBeyondItsPriorCostsWhatThePriorSays) {
  const Refit fit = refit_baseline(problem_of(example_ball(damping_number), 1.1));
  EXPECT_NEAR(fit.gain, 1.1, 0.03);  // speeds give way a little
  EXPECT_GT(fit.chi_square, 5.0);
  EXPECT_LT(fit.chi_square, 25.1);
}

TEST(TrialRefit, DampingStaysAtZeroOrAbove) {
  BaselineBall elastic = example_ball(0.0);
  const Refit fit = refit_baseline(problem_of(elastic, 1.0));
  EXPECT_GE(fit.ball.damping, 0.0);
  EXPECT_LT(fit.chi_square, 1.0);
}

}  // namespace
}  // namespace trials::testing
