// What the points of curves cost where they are smooth.
#include "comparisons/discrepancy/diagnosis/fits/smoothed_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

constexpr double each = 7.0;    // ln N of a thousand data
constexpr double error = 1e-3;  // of every point

/// Second differences of so many points, which end at zero beyond the last or nowhere.
Eigen::MatrixXd roughness_of(Eigen::Index points, bool ends_at_zero) {
  const Eigen::Index rows = points - (ends_at_zero ? 1 : 2);
  Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(rows, points);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < 3 && i + j < points; ++j)
      differences(i, i + j) = j == 1 ? -2.0 : 1.0;
  return differences.transpose() * differences;
}

/// Points that data tell apart, all as well.
FittedNumbers curve(const Eigen::VectorXd& value, bool ends_at_zero = false) {
  const Eigen::Index points = value.size();
  return {.value = value,
          .covariance = Eigen::MatrixXd::Identity(points, points) * error * error,
          .prior = Eigen::VectorXd::Zero(points),
          .roughness = {roughness_of(points, ends_at_zero)}};
}

Eigen::VectorXd line() {
  return Eigen::VectorXd::LinSpaced(6, 0.1, 0.6);
}

const Eigen::VectorXd& rough() {
  static const Eigen::VectorXd value{{0.2, -0.3, 0.4, -0.1, 0.3, -0.2}};
  return value;
}

TEST(SmoothedNumbersTest, ALineIsTwoNumbers) {
  const CostOfNumbers cost = smoothest(curve(line()), each);
  EXPECT_NEAR(cost.numbers, 2.0, 1e-3);
  EXPECT_NEAR(cost.lost_chi_square, 0.0, 1e-6);
}

TEST(SmoothedNumbersTest, ALineThatEndsAtNothingIsOne) {
  const CostOfNumbers cost =
      smoothest(curve(Eigen::VectorXd::LinSpaced(5, -0.5, -0.1), true), each);
  EXPECT_NEAR(cost.numbers, 1.0, 1e-3);
  EXPECT_NEAR(cost.lost_chi_square, 0.0, 1e-6);
}

TEST(SmoothedNumbersTest, WhatIsRoughStaysSo) {
  const CostOfNumbers cost = smoothest(curve(rough()), each);
  EXPECT_NEAR(cost.numbers, 6.0, 0.1);
  EXPECT_LT(cost.lost_chi_square, 0.1);
}

// Roughness of the size of the errors is not worth what it costs, and what is given up is counted.
TEST(SmoothedNumbersTest, NoiseOnALineIsGivenUp) {
  Eigen::VectorXd value = line();
  for (Eigen::Index i = 0; i < value.size(); ++i) value(i) += (i % 2 == 0 ? 1.0 : -1.0) * error;
  const CostOfNumbers cost = smoothest(curve(value), each);
  EXPECT_LT(cost.numbers, 2.1);
  // All but what a line through the six takes: 6 − Σ of ±1 on the constant and the slope.
  EXPECT_NEAR(cost.lost_chi_square, 6.0 - 9.0 / 17.5, 0.1);
}

TEST(SmoothedNumbersTest, APriorTakesItsShare) {
  const FittedNumbers numbers{.value = Eigen::VectorXd::Constant(1, 0.3),
                              .covariance = Eigen::MatrixXd::Constant(1, 1, 0.04),
                              .prior = Eigen::VectorXd::Constant(1, 1.0 / 0.16),
                              .roughness = {}};
  EXPECT_NEAR(smoothest(numbers, each).numbers, 1.0 - 0.04 / 0.16, 1e-12);
}

TEST(SmoothedNumbersTest, TwoCurvesAreAsSmoothAsEachIs) {
  Eigen::VectorXd value(12);
  value << line(), rough();
  FittedNumbers both = curve(value);
  const Eigen::MatrixXd one = roughness_of(6, false);
  both.roughness = {Eigen::MatrixXd::Zero(12, 12), Eigen::MatrixXd::Zero(12, 12)};
  both.roughness[0].topLeftCorner(6, 6) = one;
  both.roughness[1].bottomRightCorner(6, 6) = one;
  EXPECT_NEAR(smoothest(both, each).numbers, 8.0, 0.1);
}

// A curve costs less than its points never for losing more than that.
TEST(SmoothedNumbersTest, CostsNoMoreThanItsPoints) {
  for (const double amplitude : {0.0, 1.0, 3.0, 10.0, 100.0}) {
    Eigen::VectorXd value = line();
    for (Eigen::Index i = 0; i < value.size(); ++i)
      value(i) += amplitude * error * std::sin(2.0 * static_cast<double>(i));
    const CostOfNumbers cost = smoothest(curve(value), each);
    EXPECT_LE(cost.with(each), 6.0 * each + 1e-9) << amplitude;
    EXPECT_GE(cost.numbers, 2.0 - 1e-6) << amplitude;
  }
}

}  // namespace
}  // namespace rebound
