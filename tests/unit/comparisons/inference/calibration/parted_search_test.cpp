// Searches of residuals that fall into parts, against the same search of all rows at once.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

constexpr std::size_t parts = 5, samples = 30;
constexpr double sigma = 0.05;

/// Shots of y = a exp(−b t) + c_k, each with a zero c_k of its own that a prior holds.
class Decays {
 public:
  explicit Decays(std::uint64_t seed) {
    test::GaussianNoise noise(seed);
    for (std::size_t k = 0; k < parts; ++k) {
      const double zero = 0.1 * noise();
      for (std::size_t i = 0; i < samples; ++i)
        data_.push_back(1.5 * std::exp(-0.7 * time(i)) + zero + sigma * noise());
    }
  }

  CalibrationProblem problem(bool by_parts) const {
    CalibrationProblem all{
        .parameters =
            {{.name = "a", .unit = "", .start = 1.0, .lowest = 0.1, .highest = 10.0, .scale = 1.0},
             {.name = "b",
              .unit = "",
              .start = 0.2,
              .lowest = 0.01,
              .highest = most_,
              .scale = 1.0,
              .prior = Prior{0.5, 1.0}}},
        .residuals =
            [this](const std::vector<double>& x) {
              std::vector<double> rows;
              for (std::size_t k = 0; k < parts; ++k)
                for (const double row : of_part(x, k)) rows.push_back(row);
              return rows;
            },
        .noise = NoiseKnowledge::known,
        .controls = {.differences = Differences::one_sided}};
    ResidualParts split{
        .parts = std::vector<ResidualParts::Part>(parts),
        .residuals = [this](const std::vector<double>& x, std::size_t k) { return of_part(x, k); }};
    for (std::size_t k = 0; k < parts; ++k) {
      split.parts[k] = {.rows = samples, .own = {all.parameters.size()}};
      all.parameters.push_back({.name = "zero " + std::to_string(k),
                                .unit = "",
                                .start = 0.0,
                                .lowest = -1.0,
                                .highest = 1.0,
                                .scale = 0.1,
                                .prior = Prior{0.0, 0.1}});
    }
    if (by_parts) all.parts = split;
    return all;
  }

  void end_at(double most) { most_ = most; }
  void without_answer_above(double rate) { no_answer_above_ = rate; }
  void with_error_in(std::size_t part) { broken_ = part; }

 private:
  static double time(std::size_t i) { return 0.1 * static_cast<double>(i); }

  std::vector<double> of_part(const std::vector<double>& x, std::size_t k) const {
    if (k == broken_) throw Error(ExitCode::corrupt_store, "this part is broken");
    if (k == 2 && x[1] > no_answer_above_) throw Error(ExitCode::solver_failed, "too fast");
    std::vector<double> rows;
    for (std::size_t i = 0; i < samples; ++i)
      rows.push_back((x[0] * std::exp(-x[1] * time(i)) + x[2 + k] - data_[k * samples + i]) /
                     sigma);
    return rows;
  }

  std::vector<double> data_;
  double most_ = 5.0, no_answer_above_ = 1e9;
  std::size_t broken_ = parts;
};

void expect_the_same(const CalibrationResult& by_parts, const CalibrationResult& at_once) {
  EXPECT_NEAR(by_parts.cost_after, at_once.cost_after, 1e-8 * at_once.cost_after);
  EXPECT_NEAR(by_parts.residual_autocorrelation, at_once.residual_autocorrelation, 1e-6);
  EXPECT_EQ(by_parts.data, at_once.data);
  EXPECT_EQ(by_parts.converged, at_once.converged);
  ASSERT_EQ(by_parts.estimates.size(), at_once.estimates.size());
  for (std::size_t i = 0; i < at_once.estimates.size(); ++i) {
    const Estimate &one = by_parts.estimates[i], &other = at_once.estimates[i];
    SCOPED_TRACE(other.name);
    EXPECT_NEAR(one.value, other.value, 1e-5);
    EXPECT_NEAR(one.standard_error, other.standard_error, 1e-4 * other.standard_error);
    EXPECT_EQ(one.identifiability, other.identifiability);
    EXPECT_EQ(one.verdict, other.verdict);
  }
  ASSERT_EQ(by_parts.correlation.size(), at_once.correlation.size());
  for (std::size_t i = 0; i < at_once.correlation.size(); ++i)
    for (std::size_t j = 0; j < at_once.correlation.size(); ++j)
      EXPECT_NEAR(by_parts.correlation[i][j], at_once.correlation[i][j], 1e-4);
}

TEST(PartedSearchTest, FindsWhatASearchOfAllRowsFinds) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Decays decays(seed);
    const CalibrationResult at_once = calibrate(decays.problem(false));
    const CalibrationResult by_parts = calibrate(decays.problem(true));
    EXPECT_LT(at_once.cost_after, 0.1 * at_once.cost_before);
    expect_the_same(by_parts, at_once);
    // Of seven differences an iteration five are of one part in five.
    EXPECT_LT(by_parts.evaluations, 0.7 * at_once.evaluations);
  }
}

TEST(PartedSearchTest, EndsAtABoundAsASearchOfAllRowsDoes) {
  Decays decays(1);
  decays.end_at(0.4);
  const CalibrationResult by_parts = calibrate(decays.problem(true));
  EXPECT_EQ(by_parts.estimates[1].identifiability, Identifiability::at_bound);
  expect_the_same(by_parts, calibrate(decays.problem(false)));
}

TEST(PartedSearchTest, KeepsAwayFromWhereOnePartHasNoAnswer) {
  Decays decays(1);
  decays.without_answer_above(0.5);
  const CalibrationResult by_parts = calibrate(decays.problem(true));
  EXPECT_LE(by_parts.estimates[1].value, 0.5);
  EXPECT_GT(by_parts.estimates[1].value, 0.4);
  EXPECT_LT(by_parts.cost_after, by_parts.cost_before);
}

TEST(PartedSearchTest, ThrowsTheErrorOfAPart) {
  const Decays whole(1);
  Decays broken(1);
  broken.with_error_in(3);
  CalibrationProblem problem = broken.problem(true);
  problem.residuals = whole.problem(false).residuals;
  try {
    calibrate(problem);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::corrupt_store);
  }
}

TEST(PartedSearchTest, RefusesAPartOfAnotherLength) {
  const Decays decays(1);
  CalibrationProblem problem = decays.problem(true);
  problem.parts->parts[1].rows = samples + 1;
  EXPECT_THROW(calibrate(problem), Error);
}

}  // namespace
}  // namespace rebound
