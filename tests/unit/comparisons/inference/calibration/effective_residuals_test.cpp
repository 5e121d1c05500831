#include "comparisons/inference/calibration/effective_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// y = a + b t with one datum in seven 50 deviations off.
CalibrationProblem line_with_wrong_data(NoiseKnowledge noise) {
  CalibrationProblem problem;
  problem.parameters = {{.name = "a", .unit = "", .start = 0.0, .lowest = -10.0, .highest = 10.0},
                        {.name = "b", .unit = "", .start = 0.0, .lowest = -10.0, .highest = 10.0}};
  problem.residuals = [](const std::vector<double>& x) {
    std::vector<double> r;
    for (int t = 0; t < 42; ++t) {
      const double wrong = t % 7 == 3 ? 5.0 : 0.0, noise_ = 0.1 * std::sin(37.0 * t);
      r.push_back((x[0] + x[1] * t - (2.0 - 0.3 * t + noise_ + wrong)) / 0.1);
    }
    return r;
  };
  problem.noise = noise;
  return problem;
}

TEST(EffectiveResidualsTest, SmallResidualsAreLeftAlone) {
  CalibrationProblem problem = line_with_wrong_data(NoiseKnowledge::known);
  const std::vector<double> at = {2.0, -0.3}, plain = problem.residuals(at);
  for (const auto loss : {RobustLoss::huber, RobustLoss::soft_l1, RobustLoss::cauchy}) {
    problem.controls.loss = loss;
    const auto soft = with_loss(problem, plain.size(), 1e4).residuals(at);
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(soft[i], plain[i], 1e-3);
  }
}

// Loss functions at r = 3 a, by their definitions.
TEST(EffectiveResidualsTest, LargeResidualsCountByTheirLoss) {
  CalibrationProblem problem;
  problem.residuals = [](const std::vector<double>&) { return std::vector<double>{-6.0, 6.0}; };
  const std::pair<RobustLoss, double> cases[] = {
      {RobustLoss::huber, 2.0 * 2.0 * 6.0 - 4.0},
      {RobustLoss::soft_l1, 2.0 * 4.0 * (std::sqrt(10.0) - 1.0)},
      {RobustLoss::cauchy, 4.0 * std::log(10.0)}};
  for (const auto& [loss, value] : cases) {
    problem.controls.loss = loss;
    const auto r = with_loss(problem, 1, 2.0).residuals({});
    EXPECT_NEAR(r[0] * r[0], value, 1e-12);
    EXPECT_LT(r[0], 0.0);
    EXPECT_EQ(r[1], 6.0);  // beyond the data: a prior
  }
}

TEST(EffectiveResidualsTest, WrongDataDoNotDecide) {
  for (const auto noise : {NoiseKnowledge::known, NoiseKnowledge::estimated}) {
    CalibrationProblem problem = line_with_wrong_data(noise);
    EXPECT_GT(std::abs(calibrate(problem).estimates[0].value - 2.0), 0.4);
    for (const auto loss : {RobustLoss::huber, RobustLoss::soft_l1, RobustLoss::cauchy}) {
      problem.controls.loss = loss;
      const auto found = calibrate(problem);
      EXPECT_NEAR(found.estimates[0].value, 2.0, 0.1);
      EXPECT_NEAR(found.estimates[1].value, -0.3, 0.005);
    }
  }
}

// One datum x = 3 ± 1 and a prior of 1 ± 0.5: mean (3 + 1·4)/(1 + 4), deviation 1/√5.
TEST(EffectiveResidualsTest, APriorIsADatum) {
  CalibrationProblem problem;
  problem.parameters = {{.name = "x",
                         .unit = "",
                         .start = 0.0,
                         .lowest = -10.0,
                         .highest = 10.0,
                         .prior = Prior{1.0, 0.5}}};
  problem.residuals = [](const std::vector<double>& x) { return std::vector<double>{x[0] - 3.0}; };
  problem.noise = NoiseKnowledge::known;
  const auto found = calibrate(problem);
  EXPECT_NEAR(found.estimates[0].value, 7.0 / 5.0, 1e-8);
  EXPECT_NEAR(found.estimates[0].standard_error, 1.0 / std::sqrt(5.0), 1e-8);
  EXPECT_EQ(found.data, 1);
  problem.noise = NoiseKnowledge::estimated;
  EXPECT_THROW(calibrate(problem), Error);
}

TEST(EffectiveResidualsTest, SaysWhenOnlyThePriorHolds) {
  CalibrationProblem problem;
  problem.parameters = {{.name = "x", .unit = "", .start = 0.0, .lowest = -10.0, .highest = 10.0},
                        {.name = "idle",
                         .unit = "",
                         .start = 0.0,
                         .lowest = -6.0,
                         .highest = 6.0,
                         .prior = Prior{0.0, 1.0}}};
  problem.residuals = [](const std::vector<double>& x) {
    return std::vector<double>{20.0 * (x[0] - 3.0), 20.0 * (x[0] - 3.01)};
  };
  problem.noise = NoiseKnowledge::known;
  const auto found = calibrate(problem);
  EXPECT_EQ(found.estimates[0].identifiability, Identifiability::identified);
  EXPECT_EQ(found.estimates[1].identifiability, Identifiability::weakly_identified);
  EXPECT_NE(found.estimates[1].verdict.find("prior"), std::string::npos);
}

}  // namespace
}  // namespace rebound
