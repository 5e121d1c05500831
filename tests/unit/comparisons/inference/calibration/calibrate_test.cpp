// Least squares against problems whose answer is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

CalibrationParameter parameter(const char* name, double start, double lowest, double highest,
                               double scale = 1.0) {
  return {.name = name,
          .unit = "",
          .start = start,
          .lowest = lowest,
          .highest = highest,
          .scale = scale};
}

/// y = a + b t at t = 0 … 19 with noise of 0.1: textbook regression.
struct Line {
  std::vector<double> y;
  explicit Line(std::uint64_t seed) {
    test::GaussianNoise noise(seed);
    for (int t = 0; t < 20; ++t) y.push_back(2.0 - 0.3 * t + 0.1 * noise());
  }
  CalibrationProblem problem(double sigma, NoiseKnowledge knowledge) const {
    return {.parameters = {parameter("a", 0.0, -10.0, 10.0), parameter("b", 0.0, -10.0, 10.0)},
            .residuals =
                [this, sigma](const std::vector<double>& x) {
                  std::vector<double> r;
                  for (std::size_t t = 0; t < y.size(); ++t)
                    r.push_back((x[0] + x[1] * static_cast<double>(t) - y[t]) / sigma);
                  return r;
                },
            .noise = knowledge,
            .controls = {}};
  }
};

TEST(CalibrateTest, AgreesWithLinearRegression) {
  const Line line(7);
  const int n = 20;
  double st = 0, stt = 0, sy = 0, sty = 0;
  for (int t = 0; t < n; ++t) {
    const double y = line.y[static_cast<std::size_t>(t)];
    st += t, stt += t * t, sy += y, sty += t * y;
  }
  const double det = n * stt - st * st;
  const double b = (n * sty - st * sy) / det, a = (sy - b * st) / n;
  double rss = 0;
  for (int t = 0; t < n; ++t) rss += std::pow(a + b * t - line.y[static_cast<std::size_t>(t)], 2);

  const auto known = calibrate(line.problem(0.1, NoiseKnowledge::known));
  EXPECT_TRUE(known.converged);
  EXPECT_NEAR(known.estimates[0].value, a, 1e-8);
  EXPECT_NEAR(known.estimates[1].value, b, 1e-9);
  EXPECT_NEAR(known.estimates[0].standard_error, 0.1 * std::sqrt(stt / det), 1e-8);
  EXPECT_NEAR(known.estimates[1].standard_error, 0.1 * std::sqrt(n / det), 1e-9);
  EXPECT_NEAR(known.estimates[0].high - known.estimates[0].value,
              1.959963985 * known.estimates[0].standard_error, 1e-9);
  EXPECT_NEAR(known.correlation[0][1], -st / std::sqrt(n * stt), 1e-7);
  EXPECT_NEAR(known.cost_after, 0.5 * rss / 0.01, 1e-7);
  EXPECT_NEAR(known.reduced_chi_square, rss / 0.01 / 18, 1e-8);

  const auto estimated = calibrate(line.problem(1.0, NoiseKnowledge::estimated));
  const double s = std::sqrt(rss / 18);
  EXPECT_NEAR(estimated.estimates[1].standard_error, s * std::sqrt(n / det), 1e-9);
  EXPECT_NEAR(estimated.estimates[1].high - estimated.estimates[1].value,
              2.100922040 * estimated.estimates[1].standard_error, 1e-8);  // t, 18 degrees
  EXPECT_NE(estimated.verdict.find("noise unknown"), std::string::npos);
  EXPECT_LT(std::abs(estimated.residual_autocorrelation), 0.5);
  EXPECT_TRUE(estimated.warnings.empty());
}

TEST(CalibrateTest, NamesAProductOfTwo) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 1.0, 0.1, 10.0), parameter("b", 1.5, 0.1, 10.0),
                        parameter("offset", 0.0, -1.0, 1.0)};
  problem.residuals = [](const std::vector<double>& x) {
    std::vector<double> r;
    for (int t = 0; t < 10; ++t)
      r.push_back(x[0] * x[1] * t + x[2] - 3.0 * t - 0.1 + 0.01 * (t % 2));
    return r;
  };
  const auto result = calibrate(problem);
  EXPECT_EQ(result.estimates[0].identifiability, Identifiability::not_identifiable);
  EXPECT_EQ(result.estimates[1].identifiability, Identifiability::not_identifiable);
  EXPECT_EQ(result.estimates[2].identifiability, Identifiability::identified);
  EXPECT_NE(result.estimates[0].verdict.find("a, b"), std::string::npos);
  EXPECT_NEAR(result.estimates[0].value * result.estimates[1].value, 3.0, 0.01);
  EXPECT_TRUE(std::isinf(result.estimates[0].standard_error));
  EXPECT_TRUE(result.correlation.empty());
}

TEST(CalibrateTest, NamesAParameterWithoutInfluence) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 0.0, -5.0, 5.0), parameter("idle", 0.5, 0.0, 1.0)};
  problem.residuals = [](const std::vector<double>& x) {
    return std::vector<double>{x[0] - 1.0, x[0] - 1.1, x[0] - 0.9};
  };
  const auto result = calibrate(problem);
  EXPECT_EQ(result.estimates[0].identifiability, Identifiability::identified);
  EXPECT_EQ(result.estimates[1].identifiability, Identifiability::not_identifiable);
  EXPECT_NE(result.estimates[1].verdict.find("do not depend"), std::string::npos);
}

TEST(CalibrateTest, SaysWhenAnEstimateSitsOnItsBound) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 0.5, 0.0, 1.0)};
  problem.residuals = [](const std::vector<double>& x) {
    return std::vector<double>{x[0] - 3.0, x[0] - 3.1};
  };
  const auto result = calibrate(problem);
  EXPECT_NEAR(result.estimates[0].value, 1.0, 1e-9);
  EXPECT_EQ(result.estimates[0].identifiability, Identifiability::at_bound);
}

TEST(CalibrateTest, KeepsAwayFromWhereTheModelHasNoAnswer) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 0.2, 0.0, 10.0)};
  problem.residuals = [](const std::vector<double>& x) {
    if (x[0] > 1.05) throw Error(ExitCode::solver_failed, "no answer");
    return std::vector<double>{std::exp(x[0]) - std::exp(1.0), 0.1 * (x[0] - 1.0)};
  };
  EXPECT_NEAR(calibrate(problem).estimates[0].value, 1.0, 1e-6);
}

TEST(CalibrateTest, OtherErrorsEndIt) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 0.2, 0.0, 10.0)};
  int calls = 0;
  problem.residuals = [&](const std::vector<double>& x) {
    if (++calls > 3) throw Error(ExitCode::input_output_failed, "disk full");
    return std::vector<double>{x[0] - 1.0, x[0] - 2.0};
  };
  try {
    calibrate(problem);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  }
}

TEST(CalibrateTest, MoreStartsFindTheDeeperValley) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", -1.9, -3.0, 3.0)};
  problem.residuals = [](const std::vector<double>& x) {  // valleys at −2 and, deeper, at 2
    return std::vector<double>{x[0] * x[0] - 4.0, 0.3 * (x[0] - 2.0)};
  };
  EXPECT_LT(calibrate(problem).estimates[0].value, 0.0);
  problem.controls.starts = 8;
  const auto first = calibrate(problem), again = calibrate(problem);
  EXPECT_NEAR(first.estimates[0].value, 2.0, 1e-6);
  EXPECT_EQ(first.estimates[0].value, again.estimates[0].value);
}

TEST(CalibrateTest, WarnsOfModelError) {
  CalibrationProblem problem;
  problem.parameters = {parameter("a", 0.0, -5.0, 5.0)};
  problem.residuals = [](const std::vector<double>& x) {
    std::vector<double> r;
    for (int t = 0; t < 50; ++t) r.push_back(x[0] - std::sin(0.1 * t));
    return r;
  };
  const auto result = calibrate(problem);
  EXPECT_GT(result.residual_autocorrelation, 0.9);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("model error"), std::string::npos);
}

TEST(CalibrateTest, StopsWhenAsked) {
  const Line line(1);
  const RunControl control{.interrupted = [] { return true; }, .progress = {}};
  try {
    calibrate(line.problem(0.1, NoiseKnowledge::known), control);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
  }
}

TEST(CalibrateTest, RefusesBadProblems) {
  const auto refused = [](const CalibrationProblem& problem) {
    try {
      calibrate(problem);
    } catch (const Error& error) {
      return error.code() == ExitCode::bad_input;
    }
    return false;
  };
  const ResidualFunction two = [](const std::vector<double>& x) {
    return std::vector<double>{x[0], 1.0};
  };
  EXPECT_TRUE(refused({.parameters = {}, .residuals = two, .controls = {}}));
  EXPECT_TRUE(
      refused({.parameters = {parameter("a", 2.0, 0.0, 1.0)}, .residuals = two, .controls = {}}));
  EXPECT_TRUE(refused(
      {.parameters = {parameter("a", 0.5, 0.0, 1.0, 0.0)}, .residuals = two, .controls = {}}));
  EXPECT_TRUE(refused({.parameters = {parameter("a", 0.5, 0.0, 1.0), parameter("b", 0.5, 0.0, 1.0),
                                      parameter("c", 0.5, 0.0, 1.0)},
                       .residuals = two,
                       .controls = {}}));
  EXPECT_TRUE(refused({.parameters = {parameter("a", 0.5, 0.0, 1.0)},
                       .residuals =
                           [](const std::vector<double>&) {
                             return std::vector<double>{std::nan(""), 1.0};
                           },
                       .controls = {}}));
}

}  // namespace
}  // namespace rebound
