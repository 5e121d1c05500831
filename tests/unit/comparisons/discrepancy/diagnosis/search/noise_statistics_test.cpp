#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {
namespace {

using std::numbers::pi;

TEST(NoiseStatisticsTest, AFrequencyIsThatOfASinusoid) {
  Eigen::VectorXd rows(400);
  for (Eigen::Index i = 0; i < rows.size(); ++i) rows(i) = std::sin(0.3 * static_cast<double>(i));
  EXPECT_NEAR(frequency_of(rows), 0.3, 0.01);
  EXPECT_NEAR(frequency_of(Eigen::VectorXd::Ones(400)), 0.0, 0.08);
}

TEST(NoiseStatisticsTest, OneStatisticIsNormal) {
  const Eigen::MatrixXd one = Eigen::VectorXd::Unit(5, 2);
  EXPECT_NEAR(quantile_of_largest(one, 0.05, 1), 1.96,
              0.08);  // three standard errors of 4000 draws
}

TEST(NoiseStatisticsTest, ManyIndependentOnesReachFurther) {
  const Eigen::MatrixXd many = Eigen::MatrixXd::Identity(50, 50);
  EXPECT_NEAR(quantile_of_largest(many, 0.05, 1), 3.28, 0.12);  // 1 - 0.95^(1/50), two-sided
}

TEST(NoiseStatisticsTest, CopiesCountOnce) {
  Eigen::MatrixXd copies(5, 10);
  copies.colwise() = Eigen::VectorXd::Unit(5, 0);
  EXPECT_NEAR(quantile_of_largest(copies, 0.05, 1), 1.96, 0.08);
}

TEST(NoiseStatisticsTest, ProductsAreThoseOfTheColumns) {
  constexpr Eigen::Index rows = 400, independent = 7, count = 90;
  // Columns in a space of seven, as a fine grid of frequencies is.
  Eigen::MatrixXd span(rows, independent), mixed(independent, count);
  for (Eigen::Index i = 0; i < span.size(); ++i) span.data()[i] = std::sin(1.7 * double(i * i));
  for (Eigen::Index i = 0; i < mixed.size(); ++i) mixed.data()[i] = std::cos(0.3 * double(i * i));
  Eigen::MatrixXd units = span * mixed;
  units.colwise().normalize();
  const Eigen::MatrixXd found = coordinates_in_own_span(units);
  EXPECT_EQ(found.cols(), independent);
  EXPECT_LT((found * found.transpose() - units.transpose() * units).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(NoiseStatisticsTest, ColumnsOfLengthZeroSayNothing) {
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(5, 3);
  EXPECT_EQ(quantile_of_largest(units, 0.05, 1), 0.0);
  units(2, 1) = 1.0;
  EXPECT_NEAR(quantile_of_largest(units, 0.05, 1), 1.96, 0.08);
}

TEST(NoiseStatisticsTest, NothingExceedsNothing) {
  EXPECT_EQ(quantile_of_largest(Eigen::MatrixXd(5, 0), 0.05, 1), 0.0);
}

/// Stationary noise of order one.
std::vector<double> alike_neighbours(double coefficient, std::size_t count, std::mt19937_64& draw) {
  std::normal_distribution<double> normal;
  std::vector<double> series;
  double last = normal(draw);
  for (std::size_t i = 0; i < count; ++i) {
    series.push_back(last);
    last = coefficient * last + std::sqrt(1.0 - coefficient * coefficient) * normal(draw);
  }
  return series;
}

// Of the power at frequency zero, as it is estimated from three stretches of 40 samples: the
// deviation of its logarithm, by 1000 repetitions, is √(2/ν).
TEST(NoiseStatisticsTest, SlowNoiseIsKnownFromFewerSamples) {
  constexpr int repetitions = 1000;
  constexpr double coefficient = 0.6, share = (1.0 - coefficient) / (1.0 + coefficient);
  std::mt19937_64 draw(1);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < repetitions; ++k) {
    std::vector<std::vector<double>> series;
    for (int stretch = 0; stretch < 3; ++stretch)
      series.push_back(alike_neighbours(coefficient, 40, draw));
    const EstimatedNoise noise = estimate_noise({series.begin(), series.end()});
    const double power =
        std::log(noise.deviation * noise.deviation / effective_share(noise.autocorrelation));
    sum += power;
    squares += power * power;
  }
  const double mean = sum / repetitions;
  const double deviation = std::sqrt(squares / repetitions - mean * mean);
  Observations seen;
  seen.noise_freedom = 120.0;
  seen.shots.resize(1);
  seen.shots[0].noise.autocorrelation = {coefficient};
  const double freedom = noise_freedom_at(seen, 0.0);
  EXPECT_NEAR(freedom, 120.0 / (1.0 + 2.0 / share), 1e-9);
  EXPECT_NEAR(deviation, std::sqrt(2.0 / freedom), 0.25 * deviation);
  EXPECT_NEAR(noise_freedom_at(seen, pi), 120.0 / (1.0 + 2.0 * share), 1e-9);
  seen.shots[0].noise.autocorrelation.clear();
  EXPECT_EQ(noise_freedom_at(seen, 0.0), 120.0);
  seen.noise_freedom = 0.0;
  EXPECT_TRUE(std::isinf(noise_freedom_at(seen, 0.0)));
  EXPECT_EQ(limit_of_estimated_noise(3.9, noise_freedom_at(seen, 0.0)), 3.9);
  EXPECT_NEAR(limit_of_estimated_noise(3.9, 1e7), 3.9, 1e-4);
  const double t = student_quantile(13.0, 1.0 - 0.5 * chi_squared_chance_above(1.0, 15.0));
  EXPECT_NEAR(limit_of_estimated_noise(std::sqrt(15.0), 13.0), t, 1e-6);
  EXPECT_NEAR(square_of_known_noise(t * t, 13.0), 15.0, 1e-6);
}

}  // namespace
}  // namespace rebound
