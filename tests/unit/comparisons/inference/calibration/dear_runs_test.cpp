// Searches that come by with few runs of a model.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/calibration_cost.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {
namespace {

/// A decay a exp(-b t) whose rate cannot be as large as the data ask for, and all runs counted.
struct BoundedDecay {
  int runs = 0;

  CalibrationResult found(bool dear) {
    CalibrationProblem problem;
    problem.parameters = {{.name = "a", .unit = "", .start = 0.3, .lowest = 0.1, .highest = 10.0},
                          {.name = "b", .unit = "", .start = 0.1, .lowest = 0.01, .highest = 1.0}};
    problem.noise = NoiseKnowledge::known;
    problem.controls.runs_are_dear = dear;
    problem.controls.differences = Differences::one_sided;
    problem.controls.cost_tolerance = 1e-6;
    problem.residuals = [this](const std::vector<double>& x) {
      ++runs;
      std::vector<double> r;
      for (int i = 0; i < 20; ++i)
        r.push_back((x[0] * std::exp(-0.2 * i * x[1]) - 2.5 * std::exp(-0.3 * i)) / 0.05);
      return r;
    };
    return calibrate(problem);
  }
};

// An ordinary search gives up 3 % above the least cost here: the way along its step, cut off by the
// bound, leads nowhere.
TEST(DearRunsTest, AtABoundTheLeastIsFoundWithFewRuns) {
  BoundedDecay decay;
  const CalibrationResult found = decay.found(true);
  ASSERT_TRUE(found.converged);
  double products = 0.0, squares = 0.0;  // of the line that is left where b is 1
  for (int i = 0; i < 20; ++i) {
    products += 2.5 * std::exp(-0.3 * i) * std::exp(-0.2 * i);
    squares += std::exp(-0.4 * i);
  }
  EXPECT_NEAR(found.estimates[0].value, products / squares, 1e-3);
  EXPECT_EQ(found.estimates[1].identifiability, Identifiability::at_bound);
  EXPECT_LT(decay.runs, 80);  // 60
}

/// A curved valley along y = x², and z that would like to be 5 and may not be more than 1.
struct ValleyBesideABound {
  int runs = 0;

  CalibrationResult found() {
    CalibrationProblem problem;
    problem.parameters = {{.name = "x", .unit = "", .start = -1.2, .lowest = -4.0, .highest = 4.0},
                          {.name = "y", .unit = "", .start = 1.0, .lowest = -9.0, .highest = 9.0},
                          {.name = "z", .unit = "", .start = 0.5, .lowest = -1.0, .highest = 1.0}};
    problem.noise = NoiseKnowledge::known;
    problem.controls.runs_are_dear = true;
    problem.controls.differences = Differences::one_sided;
    problem.controls.cost_tolerance = 1e-6;
    problem.residuals = [this](const std::vector<double>& x) -> std::vector<double> {
      ++runs;
      return {10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0], 8.0 - x[2] - 3.0 * x[0]};
    };
    return calibrate(problem);
  }
};

// With z at its bound the least is where 10 x = 22. A search that steps with z and is cut off there
// takes 156 runs.
TEST(DearRunsTest, ABoundTakesNothingFromTheStepsOfTheOthers) {
  ValleyBesideABound valley;
  const CalibrationResult found = valley.found();
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.estimates[0].value, 2.2, 1e-3);
  EXPECT_NEAR(found.estimates[1].value, 2.2 * 2.2, 5e-3);
  EXPECT_EQ(found.estimates[2].identifiability, Identifiability::at_bound);
  EXPECT_LT(valley.runs, 110);  // 88
}

// x + y is known a hundred times as well as x − y, and nothing explains a rest of 10. Short steps
// move along x − y so little that each gains less than the tolerance: a search that ends there
// leaves x − y near 0 and a cost of 54 for 50.
TEST(DearRunsTest, AValleyIsFollowedToItsEnd) {
  int runs = 0;
  CalibrationProblem problem;
  problem.parameters = {{.name = "x", .unit = "", .start = 0.0, .lowest = -90.0, .highest = 90.0},
                        {.name = "y", .unit = "", .start = 0.0, .lowest = -90.0, .highest = 90.0}};
  problem.noise = NoiseKnowledge::known;
  problem.controls.runs_are_dear = true;
  problem.controls.differences = Differences::one_sided;
  problem.controls.cost_tolerance = 3e-4;
  problem.residuals = [&](const std::vector<double>& x) -> std::vector<double> {
    ++runs;
    return {100.0 * (x[0] + x[1] - 2.0), 0.3 * (x[0] - x[1] - 10.0), 10.0};
  };
  const CalibrationResult found = calibrate(problem);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.estimates[0].value, 6.0, 0.4);  // 3e-4 of the cost
  EXPECT_NEAR(found.estimates[1].value, -4.0, 0.4);
  EXPECT_LT(runs, 40);
}

/// a exp(-b t) + c against data of it, its Jacobian taken by the model itself.
struct CountedModel {
  int runs = 0, jacobians = 0;

  CalibrationProblem problem(bool dear) {
    CalibrationProblem problem;
    problem.parameters = {{.name = "a", .unit = "", .start = 0.5, .lowest = 0.1, .highest = 10.0},
                          {.name = "b", .unit = "", .start = 0.2, .lowest = 0.01, .highest = 9.0},
                          {.name = "c", .unit = "", .start = 0.0, .lowest = -5.0, .highest = 5.0}};
    problem.noise = NoiseKnowledge::known;
    problem.controls.runs_are_dear = dear;
    problem.controls.cost_tolerance = 1e-8;
    problem.residuals = [this](const std::vector<double>& x) {
      ++runs;
      return at(x).residuals;
    };
    problem.with_jacobian = [this](const std::vector<double>& x) {
      ++jacobians;
      return at(x);
    };
    return problem;
  }
  static ResidualsWithJacobian at(const std::vector<double>& x) {
    ResidualsWithJacobian found;
    for (int i = 0; i < 20; ++i) {
      const double t = 0.2 * i, decay = std::exp(-x[1] * t), data = 2.5 * std::exp(-1.5 * t) + 0.7;
      found.residuals.push_back((x[0] * decay + x[2] - data + 0.01 * (i % 3)) / 0.05);
      found.slopes.insert(found.slopes.end(), {decay / 0.05, -t * x[0] * decay / 0.05, 1.0 / 0.05});
    }
    return found;
  }
};

TEST(DearRunsTest, FewJacobiansLeadToTheSameEnd) {
  CountedModel plain, dear;
  const CalibrationResult as_ever = calibrate(plain.problem(false)),
                          sparing = calibrate(dear.problem(true));
  ASSERT_TRUE(as_ever.converged && sparing.converged);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(sparing.estimates[i].value, as_ever.estimates[i].value, 1e-5) << i;
    EXPECT_NEAR(sparing.estimates[i].standard_error, as_ever.estimates[i].standard_error,
                1e-4 * as_ever.estimates[i].standard_error)
        << i;
  }
  EXPECT_LT(2 * dear.jacobians, plain.jacobians) << dear.runs;
}

// A point is asked for its residuals; for its Jacobian only where it is accepted; and where the
// next one is refused, nothing is asked again.
TEST(DearRunsTest, ARefusedPointIsNotAskedForItsJacobian) {
  CountedModel model;
  const CalibrationProblem problem = model.problem(true);
  const CalibrationCost cost(problem, 20);
  const std::vector<double> accepted{1.0, 1.0, 0.5}, refused{3.0, 1.0, 0.5};
  std::vector<double> residuals(20), slopes(60);
  const auto ask = [&](const std::vector<double>& y, bool with_slopes) {
    const double* at[] = {y.data()};
    double* out[] = {slopes.data()};
    ASSERT_TRUE(cost.Evaluate(at, residuals.data(), with_slopes ? out : nullptr));
    EXPECT_EQ(residuals, CountedModel::at(y).residuals);
    if (with_slopes) {
      EXPECT_EQ(slopes, CountedModel::at(y).slopes);
    }
  };
  ask(accepted, false);
  EXPECT_EQ(model.jacobians, 0);
  ask(accepted, true);
  ask(refused, false);
  ask(accepted, true);
  EXPECT_EQ(model.jacobians, 1);
  EXPECT_EQ(model.runs, 2);
}

}  // namespace
}  // namespace rebound
