#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

constexpr std::size_t n = 24;

MeasuredImpact history(double deviation, std::vector<double> autocorrelation) {
  return {.trace = {.force = std::vector<double>(n, 0.0)},
          .noise = {.deviation = deviation, .autocorrelation = std::move(autocorrelation)}};
}

/// W C Wᵀ: of errors with the covariance C, what whitening leaves of it.
std::vector<double> whitened_covariance(const ForceNoise& noise, std::vector<double> covariance) {
  const auto apply = [&](std::vector<double>& rows) {
    for (double& r : rows) r /= noise.deviation;
    take_out_correlation(noise, rows, n);
  };
  apply(covariance);
  std::vector<double> turned(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) turned[j * n + i] = covariance[i * n + j];
  apply(turned);
  return turned;
}

// Slow noise of 2 N, neighbours alike by 0.95, and a white error of 3 N beside it.
TEST(NumericalErrorOfHistoryTest, IsWhiteBesideSlowNoise) {
  constexpr double noise = 2.0, error = 3.0, alike = 0.95;
  MeasuredImpact shot = history(noise, {alike});
  add_numerical_error(shot, error);
  shot.noise.shared = 0.0;  // what blocks share is an error of its own
  std::vector<double> covariance(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      covariance[i * n + j] =
          noise * noise *
              std::pow(alike, std::abs(static_cast<double>(i) - static_cast<double>(j))) +
          (i == j ? error * error : 0.0);
  const std::vector<double> left = whitened_covariance(shot.noise, covariance);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(left[i * n + j], i == j ? 1.0 : 0.0, 1e-12);
}

TEST(NumericalErrorOfHistoryTest, IsSharedByBlocks) {
  MeasuredImpact shot = history(3.0, {});
  add_numerical_error(shot, 4.0);
  EXPECT_DOUBLE_EQ(shot.noise.deviation, 5.0);
  EXPECT_TRUE(shot.noise.autocorrelation.empty());
  EXPECT_EQ(shot.noise.shared, 4.0);
  EXPECT_EQ(shot.noise.shared_by, n / 8);
}

TEST(NumericalErrorOfHistoryTest, NoneLeavesTheNoiseAsItIs) {
  MeasuredImpact shot = history(3.0, {0.7, 0.4});
  add_numerical_error(shot, 0.0);
  EXPECT_EQ(shot.noise.deviation, 3.0);
  EXPECT_EQ(shot.noise.autocorrelation, (std::vector<double>{0.7, 0.4}));
}

}  // namespace
}  // namespace rebound
