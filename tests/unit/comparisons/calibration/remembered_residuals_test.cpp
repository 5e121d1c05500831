#include "comparisons/calibration/remembered_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

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

TEST(RememberedResidualsTest, AKilledCalibrationGoesOnToTheSameBits) {
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

TEST(RememberedResidualsTest, WhereTheModelHasNoAnswerIsRememberedToo) {
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

TEST(RememberedResidualsTest, DamagedIsCorruptForeignIsBadInput) {
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
  for (const std::string& bad : {good.substr(0, good.size() / 2), std::string("{}"), std::string(), flipped}) {
    std::ofstream(file) << bad;
    EXPECT_EQ(code_of({}), ExitCode::corrupt_store) << bad.substr(0, 40);
  }
}

}  // namespace
}  // namespace rebound
