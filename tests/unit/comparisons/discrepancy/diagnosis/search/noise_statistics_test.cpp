#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

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

}  // namespace
}  // namespace rebound
