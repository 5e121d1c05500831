#include "comparisons/inference/calibration/autocorrelation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/gaussian_noise.hpp"

namespace rebound {
namespace {

std::vector<double> first_order(std::size_t count, double coefficient, unsigned seed) {
  test::GaussianNoise normal(seed);
  std::vector<double> series;
  double last = normal();
  for (std::size_t i = 0; i < count; ++i) {
    series.push_back(last);
    last = coefficient * last + std::sqrt(1.0 - coefficient * coefficient) * normal();
  }
  return series;
}

TEST(AutocorrelationTest, PredictorsOfAFirstOrderSeries) {
  const LinearPredictors found = linear_predictors({0.7, 0.49, 0.343});
  EXPECT_NEAR(found.coefficients[3][0], 0.7, 1e-14);
  EXPECT_NEAR(found.coefficients[3][1], 0.0, 1e-14);
  EXPECT_NEAR(found.variance[3], 1.0 - 0.49, 1e-14);
}

TEST(AutocorrelationTest, GoesOnAsItsSeriesDoes) {
  const std::vector<double> first_order = continued({0.7}, 3);
  ASSERT_EQ(first_order.size(), 3u);
  EXPECT_NEAR(first_order[2], 0.343, 1e-14);
  // ρ_l = 1.2 ρ_(l−1) − 0.4 ρ_(l−2), from ρ_1 = 1.2/1.4.
  const double first = 1.2 / 1.4, second = 1.2 * first - 0.4;
  const std::vector<double> second_order = continued({first, second}, 4);
  ASSERT_EQ(second_order.size(), 4u);
  EXPECT_NEAR(second_order[3], 1.2 * (1.2 * second - 0.4 * first) - 0.4 * second, 1e-14);
  EXPECT_TRUE(continued({}, 5).empty());
  EXPECT_EQ(continued({0.5, 0.4}, 1).size(), 2u);  // none is taken away
}

TEST(AutocorrelationTest, WhiteNoiseIsWhite) {
  int coloured = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto series = first_order(300, 0.0, seed);
    if (!estimate_noise({series}).autocorrelation.empty()) ++coloured;
  }
  EXPECT_LE(coloured, 10);
}

TEST(AutocorrelationTest, FindsAnAutoregressiveSeries) {
  const auto series = first_order(4000, 0.7, 3);
  const EstimatedNoise noise = estimate_noise({series});
  ASSERT_FALSE(noise.autocorrelation.empty());
  const LinearPredictors found = linear_predictors(noise.autocorrelation);
  EXPECT_NEAR(found.coefficients.back()[0], 0.7, 0.05);
  EXPECT_NEAR(noise.deviation, 1.0, 0.1);
}

TEST(AutocorrelationTest, ShortStretchesTellTogether) {
  std::vector<std::vector<double>> parts;
  for (unsigned seed = 0; seed < 10; ++seed) parts.push_back(first_order(30, 0.7, seed));
  const std::vector<std::span<const double>> stretches(parts.begin(), parts.end());
  const EstimatedNoise noise = estimate_noise(stretches);
  EXPECT_EQ(noise.samples, 300);
  EXPECT_FALSE(noise.autocorrelation.empty());
}

// What a signal is compared to is what neighbours do not tell: (1 − p²)³/(1 + p²) of the variance
// for white noise through two poles at p. Products of neighbours over the number of all samples
// would give three times as much.
TEST(AutocorrelationTest, ShortStretchesOfSlowNoiseTellWhatNeighboursDoNot) {
  constexpr double p = 0.8;
  std::vector<std::vector<double>> parts;
  for (unsigned seed = 0; seed < 40; ++seed) {
    test::GaussianNoise normal(seed);
    double first = 0.0, second = 0.0;
    std::vector<double>& part = parts.emplace_back();
    for (int i = -200; i < 40; ++i) {
      first = p * first + normal();
      second = p * second + first;
      if (i >= 0) part.push_back(second);
    }
  }
  const std::vector<std::span<const double>> stretches(parts.begin(), parts.end());
  const EstimatedNoise noise = estimate_noise(stretches);
  const double left = linear_predictors(noise.autocorrelation).variance.back();
  EXPECT_NEAR(noise.deviation * noise.deviation * left, 1.0, 0.15);
}

TEST(AutocorrelationTest, AnOffsetAndADriftAreNoNoise) {
  auto series = first_order(200, 0.0, 5);
  const double alone = estimate_noise({series}).deviation;
  for (std::size_t i = 0; i < series.size(); ++i) series[i] += 30.0 + 0.7 * static_cast<double>(i);
  const EstimatedNoise noise = estimate_noise({series});
  EXPECT_NEAR(noise.deviation, alone, 1e-9);
  EXPECT_TRUE(noise.autocorrelation.empty());
}

TEST(AutocorrelationTest, NothingToSeeIsNothing) {
  EXPECT_EQ(estimate_noise({}).deviation, 0.0);
  const std::vector<double> still(50, 3.0);
  EXPECT_EQ(estimate_noise({still}).deviation, 0.0);
}

// (1 − ρ)/(1 + ρ) of a first-order series.
TEST(AutocorrelationTest, EffectiveShareOfAFirstOrderSeries) {
  EXPECT_NEAR(effective_share({0.5}), 1.0 / 3.0, 1e-14);
  EXPECT_EQ(effective_share({}), 1.0);
  // (1 − ρ²)/(1 + ρ²) for the variance
  EXPECT_NEAR(effective_share_of_variance({0.5}), 0.75 / 1.25, 1e-12);
  EXPECT_EQ(effective_share_of_variance({}), 1.0);
}

}  // namespace
}  // namespace rebound
