#include "comparisons/inference/calibration/evaluation_cache.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// Rosenbrock's valley, which takes some iterations; counts its calls.
struct Valley {
  int calls = 0;
  int allowed = 1000000;
  double offset = 0.0;
  CalibrationProblem problem(const std::filesystem::path& checkpoint) {
    CalibrationProblem p;
    p.parameters = {{.name = "x", .unit = "", .start = -1.2, .lowest = -5.0, .highest = 5.0},
                    {.name = "y", .unit = "", .start = 1.0, .lowest = -5.0, .highest = 5.0}};
    p.residuals = [this](const std::vector<double>& x) {
      if (++calls > allowed) throw Error(ExitCode::interrupted, "killed");
      return std::vector<double>{10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0], offset};
    };
    p.controls.checkpoint = checkpoint;
    return p;
  }
};

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(EvaluationCacheTest, AKilledCalibrationGoesOnToTheSameBits) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "checkpoint.json";
  Valley whole;
  const auto expected = calibrate(whole.problem({}));
  Valley killed;
  killed.allowed = 20;
  EXPECT_THROW(calibrate(killed.problem(file)), Error);
  Valley resumed;
  const auto found = calibrate(resumed.problem(file));
  EXPECT_LT(resumed.calls, whole.calls - 10);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found.estimates[i].value, expected.estimates[i].value);
    EXPECT_EQ(found.estimates[i].standard_error, expected.estimates[i].standard_error);
  }
  EXPECT_EQ(found.cost_after, expected.cost_after);
}

// A real kill -9: a child process calibrates slowly and dies while it does.
TEST(EvaluationCacheTest, ACalibrationKilledByTheSystemGoesOnToTheSameBits) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "checkpoint.json";
  Valley whole;
  const auto expected = calibrate(whole.problem({}));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Valley slow;
    CalibrationProblem problem = slow.problem(file);
    problem.residuals = [inner = problem.residuals](const std::vector<double>& x) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      return inner(x);
    };
    calibrate(problem);
    _exit(0);  // not reached: some hundred evaluations take longer than the test waits
  }
  const auto begun = std::chrono::steady_clock::now();
  while (!std::filesystem::exists(file) &&
         std::chrono::steady_clock::now() - begun < std::chrono::seconds(30))
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_EQ(kill(child, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status)) << "it ended before it was killed";
  Valley resumed;
  const auto found = calibrate(resumed.problem(file));
  EXPECT_LT(resumed.calls, whole.calls - 10);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(found.estimates[i].value, expected.estimates[i].value);
  EXPECT_EQ(found.cost_after, expected.cost_after);
}

// With slopes of its own a model is asked less often, and goes on just as well.
TEST(EvaluationCacheTest, SlopesAreCachedToo) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "checkpoint.json";
  const auto with_slopes = [&](Valley& valley, const std::filesystem::path& checkpoint) {
    CalibrationProblem problem = valley.problem(checkpoint);
    problem.with_jacobian = [inner = problem.residuals](const std::vector<double>& x) {
      return ResidualsWithJacobian{inner(x), {-20.0 * x[0], 10.0, -1.0, 0.0, 0.0, 0.0}};
    };
    return problem;
  };
  Valley plain, whole;
  const auto differenced = calibrate(plain.problem({}));
  const auto expected = calibrate(with_slopes(whole, {}));
  EXPECT_LT(2 * whole.calls, plain.calls);
  EXPECT_NEAR(expected.estimates[0].value, differenced.estimates[0].value, 1e-6);
  Valley killed;
  killed.allowed = 10;
  EXPECT_THROW(calibrate(with_slopes(killed, file)), Error);
  Valley resumed;
  const auto found = calibrate(with_slopes(resumed, file));
  EXPECT_LT(resumed.calls, whole.calls);
  EXPECT_EQ(found.estimates[0].value, expected.estimates[0].value);
  EXPECT_EQ(found.cost_after, expected.cost_after);
}

TEST(EvaluationCacheTest, WhereTheModelHasNoAnswerIsCachedToo) {
  testing::TemporaryFolder folder;
  CalibrationProblem problem;
  problem.parameters = {{.name = "a", .unit = "", .start = 0.2, .lowest = 0.0, .highest = 10.0}};
  int failures = 0;
  problem.residuals = [&](const std::vector<double>& x) {
    if (x[0] > 1.05) {
      ++failures;
      throw Error(ExitCode::solver_failed, "no answer");
    }
    return std::vector<double>{std::exp(x[0]) - std::exp(1.0), 0.1 * (x[0] - 1.0)};
  };
  problem.controls.checkpoint = folder.path() / "checkpoint.json";
  const double first = calibrate(problem).estimates[0].value;
  const int before = failures;
  EXPECT_GT(before, 0);
  EXPECT_EQ(calibrate(problem).estimates[0].value, first);
  EXPECT_EQ(failures, before);
}

TEST(EvaluationCacheTest, DamagedIsCorruptForeignIsBadInput) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "checkpoint.json";
  const auto code_of = [&](Valley valley) {
    try {
      calibrate(valley.problem(file));
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::done;
  };
  EXPECT_EQ(code_of({}), ExitCode::done);
  const std::string good = text_of(file);
  EXPECT_EQ(code_of({.offset = 0.1}), ExitCode::bad_input);  // other data
  std::string flipped = good;
  const auto digit = flipped.find("evaluations") + 60;
  flipped[flipped.find_first_of("123456789", digit)] = '0';
  for (const std::string& bad :
       {good.substr(0, good.size() / 2), std::string("{}"), std::string(), flipped}) {
    std::ofstream(file) << bad;
    EXPECT_EQ(code_of({}), ExitCode::corrupt_store) << bad.substr(0, 40);
  }
}

}  // namespace
}  // namespace rebound
