#include "comparisons/inference/calibration/whitening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {
namespace {

TEST(WhiteningTest, SharedErrorBoundsABlock) {
  MeasuredImpact history{.trace = {.force = std::vector<double>(40, 0.0)},
                         .noise = {.deviation = 2.0}};
  const std::vector<double> model(40, 1.0);
  for (const double r : whitened(history, model)) EXPECT_EQ(r, 0.5);
  history.noise.shared = 1.0;
  history.noise.shared_by = 20;
  // A constant misfit of 1 over a block that is known to 1: about one standard deviation.
  const auto r = whitened(history, model);
  const double chi_square = std::inner_product(r.begin(), r.begin() + 20, r.begin(), 0.0);
  EXPECT_NEAR(chi_square, 1.0 / (1.0 + 4.0 / 20.0), 1e-12);
}

// W C Wᵀ = 1 for the covariance of a block, column by column.
TEST(WhiteningTest, UndoesTheCovarianceOfABlock) {
  constexpr std::size_t n = 5;
  const ForceNoise noise{.deviation = 2.0, .shared = 3.0, .shared_by = n};
  std::vector<double> covariance(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) covariance[i * n + j] = 9.0 + (i == j ? 4.0 : 0.0);
  const auto apply = [&](std::vector<double> rows) {
    for (double& r : rows) r /= noise.deviation;
    take_out_correlation(noise, rows, n);
    return rows;
  };
  std::vector<double> half = apply(covariance), turned(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) turned[j * n + i] = half[i * n + j];
  const std::vector<double> unit = apply(turned);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(unit[i * n + j], i == j ? 1.0 : 0.0, 1e-12);
}

// The same for noise whose neighbours are alike: an autoregressive series of order two.
TEST(WhiteningTest, UndoesTheCovarianceOfCorrelatedNoise) {
  constexpr std::size_t n = 12;
  const std::vector<double> autocorrelation{0.8, 0.55};
  const LinearPredictors predictors = linear_predictors(autocorrelation);
  std::vector<double> rho{1.0, 0.8, 0.55};
  for (std::size_t lag = 3; lag < n; ++lag)
    rho.push_back(predictors.coefficients[2][0] * rho[lag - 1] +
                  predictors.coefficients[2][1] * rho[lag - 2]);
  const ForceNoise noise{.deviation = 3.0, .autocorrelation = autocorrelation};
  std::vector<double> covariance(n * n), turned(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) covariance[i * n + j] = rho[i > j ? i - j : j - i];
  take_out_correlation(noise, covariance, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) turned[j * n + i] = covariance[i * n + j];
  take_out_correlation(noise, turned, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(turned[i * n + j], i == j ? 1.0 : 0.0, 1e-12);
}

}  // namespace
}  // namespace rebound
