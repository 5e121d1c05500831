// Searches that come by with few runs of a model.
#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace rebound
