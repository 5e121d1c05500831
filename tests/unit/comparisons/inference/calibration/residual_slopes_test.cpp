// Slopes of a fit's residuals are those of the residuals, whatever the unknown.
#include "comparisons/inference/calibration/residual_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/differences.hpp"
#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/inference/calibration/force_deflection_residuals.hpp"
#include "comparisons/inference/calibration/force_time_residuals.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

std::vector<MeasuredImpact> two_shots(const std::vector<double>& autocorrelation = {}) {
  std::vector<MeasuredImpact> shots;
  for (double speed : {5.0, 15.0}) {
    LumpedProblem problem = test::typical_problem("hunt-crossley");
    problem.impact.speed = speed;
    problem.controls.samples = 60;
    const LumpedResult run = simulate_fast(problem);
    shots.push_back({.sphere = problem.sphere,
                     .impact = problem.impact,
                     .trace = run.trace,
                     .noise = {.deviation = 5.0, .autocorrelation = autocorrelation},
                     .scalars = run.scalars});
  }
  return shots;
}

/// Slopes of every unknown against central differences; what counts is the change for the
/// parameter's own scale, over the largest of the column.
void expect_slopes(const CalibrationProblem& problem, const std::vector<double>& x) {
  const ResidualsWithJacobian found = problem.with_jacobian(x);
  const auto plain = problem.residuals(x);
  ASSERT_EQ(found.residuals.size(), plain.size());
  ASSERT_EQ(found.slopes.size(), plain.size() * x.size());
  for (std::size_t i = 0; i < plain.size(); ++i)
    EXPECT_NEAR(found.residuals[i], plain[i], 1e-6 * (1.0 + std::abs(plain[i])));
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double h = 1e-4 * problem.parameters[j].scale;
    auto above = x, below = x;
    above[j] += h;
    below[j] -= h;
    const auto a = problem.residuals(above), b = problem.residuals(below);
    double largest = 0.0;
    for (std::size_t i = 0; i < plain.size(); ++i)
      largest = std::max(largest, std::abs(a[i] - b[i]) / (2.0 * h));
    ASSERT_GT(largest, 0.0) << problem.parameters[j].name;
    for (std::size_t i = 0; i < plain.size(); ++i)
      EXPECT_NEAR(found.slopes[i * x.size() + j], (a[i] - b[i]) / (2.0 * h), 2e-3 * largest)
          << problem.parameters[j].name << " at datum " << i;
  }
}

template <class Residuals>
void expect_slopes_of(Observable observable, const Nuisances& errors,
                      const std::vector<double>& autocorrelation = {}) {
  const auto shots = two_shots(autocorrelation);
  LawCalibrationOptions options;
  options.observable = observable;
  options.nuisances = errors;
  options.tip_margin = 0.05;  // the curve is vertical there, and differences are wrong
  const LawUnknowns law("hunt-crossley", shots,
                        {.fixed = {}, .also_free = {"exponent"}, .per_speed = {"damping"}});
  const Residuals residuals(shots, options);
  CalibrationProblem problem;
  problem.parameters = law.parameters();
  NuisanceUnknowns nuisances(shots.size());
  nuisances.add_asked(errors, problem.parameters);
  const auto model = [&](const std::vector<double>& x) {
    return [&](std::size_t i) { return law.model_for(x, i); };
  };
  const auto record = [&](const std::vector<double>& x) {
    return [&](std::size_t i) {
      MeasurementChain chain;
      nuisances.apply(x, i, chain);
      return chain;
    };
  };
  problem.residuals = [&](const std::vector<double>& x) { return residuals(model(x), record(x)); };
  problem.with_jacobian = [&](const std::vector<double>& x) {
    return residuals.with_jacobian(model(x), record(x), [&](std::size_t i) {
      return ShotUnknowns{
          .law = law.slopes_for(i), .nuisances = nuisances.places(i), .count = x.size()};
    });
  };
  std::vector<double> x;
  for (const auto& p : problem.parameters) x.push_back(p.start);
  // Reaching farther than the data, so that no datum lies beyond the model's turning point.
  x[1] *= 0.7;
  for (std::size_t i = law.parameters().size(); i < x.size(); ++i)
    x[i] += 0.1 * problem.parameters[i].scale;
  expect_slopes(problem, x);
}

const Nuisances over_deflection{
    {{"gain", 0.02}, {"baseline", 10.0}, {"speed", 0.01}, {"mass", 0.01}}};
const Nuisances over_time{
    {{"gain", 0.02}, {"trigger", 1e-5}, {"baseline", 10.0}, {"speed", 0.01}, {"mass", 0.01}}};

TEST(ResidualSlopesTest, ForceOverDeflection) {
  expect_slopes_of<ForceDeflectionResiduals>(Observable::force_deflection, over_deflection);
}

TEST(ResidualSlopesTest, ForceOverTime) {
  expect_slopes_of<ForceTimeResiduals>(Observable::force_time, over_time);
}

TEST(ResidualSlopesTest, UnderCorrelatedNoise) {
  expect_slopes_of<ForceDeflectionResiduals>(Observable::force_deflection, over_deflection,
                                             {0.6, 0.3});
  expect_slopes_of<ForceTimeResiduals>(Observable::force_time, over_time, {0.6, 0.3});
}

/// Under correlated noise the residuals are those under white noise, whitened shot by shot.
template <class Residuals>
void expect_whitened(Observable observable) {
  const auto residuals_of = [&](const std::vector<MeasuredImpact>& shots) {
    LumpedModel model = test::typical_problem("hunt-crossley").model;
    model.parameters["stiffness"] *= 0.8;
    LawCalibrationOptions options;
    options.observable = observable;
    return Residuals(shots, options)([&](std::size_t) { return model; },
                                     [](std::size_t) { return MeasurementChain{}; });
  };
  const auto white = two_shots(), coloured = two_shots({0.6, 0.3});
  for (std::size_t k = 0; k < white.size(); ++k) {
    std::vector<double> expected = residuals_of({white[k]});
    take_out_correlation(coloured[k].noise, expected);
    const std::vector<double> found = residuals_of({coloured[k]});
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
  }
}

TEST(ResidualSlopesTest, ResidualsAreWhitened) {
  expect_whitened<ForceDeflectionResiduals>(Observable::force_deflection);
  expect_whitened<ForceTimeResiduals>(Observable::force_time);
}

TEST(ResidualSlopesTest, LossesAndPriors) {
  CalibrationProblem problem;
  problem.parameters = {{.name = "a", .unit = "", .start = 1.0, .lowest = -9.0, .highest = 9.0},
                        {.name = "b",
                         .unit = "",
                         .start = 1.0,
                         .lowest = -9.0,
                         .highest = 9.0,
                         .prior = Prior{0.5, 0.2}}};
  problem.noise = NoiseKnowledge::known;
  problem.with_jacobian = [](const std::vector<double>& x) {
    ResidualsWithJacobian r;
    for (double t : {0.1, 1.0, 2.0, 7.0}) {
      r.residuals.push_back(x[0] * t - x[1] * x[1]);
      r.slopes.insert(r.slopes.end(), {t, -2.0 * x[1]});
    }
    return r;
  };
  problem.residuals = [&](const std::vector<double>& x) {
    return problem.with_jacobian(x).residuals;
  };
  for (const auto loss :
       {RobustLoss::none, RobustLoss::huber, RobustLoss::soft_l1, RobustLoss::cauchy}) {
    problem.controls.loss = loss;
    expect_slopes(with_loss(with_priors(problem), 4, 1.3), {1.1, 0.7});
  }
}

// r = x², which has no value above 1: at 1 the slope is that of the other side.
TEST(ResidualSlopesTest, ASideWithoutAnImpactIsLeftOut) {
  const auto square = [](const std::vector<double>& x) {
    if (x[0] > 1.0) throw Error(ExitCode::solver_failed, "does not end");
    return std::vector<double>{x[0] * x[0]};
  };
  std::vector<CalibrationParameter> unknown(1);
  unknown[0].scale = 1.0;
  unknown[0].lowest = -10.0;
  unknown[0].highest = 10.0;
  EXPECT_NEAR(with_differences(unknown, square, {1.0}, 1e-4).slopes[0], 2.0, 2e-4);
  EXPECT_NEAR(with_differences(unknown, square, {0.5}, 1e-4).slopes[0], 1.0, 1e-9);
  unknown[0].lowest = 1.0;
  EXPECT_THROW(with_differences(unknown, square, {1.0}, 1e-4), Error);
}

}  // namespace
}  // namespace rebound
