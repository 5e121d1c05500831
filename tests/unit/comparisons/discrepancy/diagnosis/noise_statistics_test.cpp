#include "comparisons/discrepancy/diagnosis/noise_statistics.hpp"

#include <gtest/gtest.h>

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

TEST(NoiseStatisticsTest, NothingExceedsNothing) {
  EXPECT_EQ(quantile_of_largest(Eigen::MatrixXd(5, 0), 0.05, 1), 0.0);
}

}  // namespace
}  // namespace rebound
