#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_gain.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

constexpr int rows = 6;

/// Residuals of noise, and of a change that is missing by `missing`; one number is fitted.
struct Case {
  Eigen::VectorXd by_number = Eigen::VectorXd::Ones(rows);
  Eigen::VectorXd change = Eigen::VectorXd::LinSpaced(rows, 0.0, 1.0);

  BesideFittedNumbers beside(double missing) const {
    Eigen::VectorXd left = -missing * change;
    left -= left.mean() * by_number;  // the number takes its share
    return {left, by_number};
  }
};

TEST(FirstOrderGainTest, WhatIsMissingIsGainedAndItsSizeIsSaid) {
  const Case one;
  const BesideFittedNumbers beside = one.beside(3.0);
  const FirstOrderGain gain = beside.sums_of(one.change).gain();
  EXPECT_NEAR(gain.chi_square, beside.residuals().squaredNorm(), 1e-12) << "all that is left";
  EXPECT_NEAR(gain.factor, 3.0, 1e-12);
  EXPECT_NEAR(beside.sums_of(-2.0 * one.change).gain().factor, -1.5, 1e-12)
      << "of the other sign, and half as much";
}

TEST(FirstOrderGainTest, WhatTheNumbersCanDoGainsNothing) {
  const Case one;
  const BesideFittedNumbers beside = one.beside(3.0);
  EXPECT_EQ(beside.sums_of(2.0 * one.by_number).gain().chi_square, 0.0);
  EXPECT_EQ(beside.sums_of(one.by_number + 1e-3 * one.change).gain().chi_square, 0.0)
      << "what is left of it is ripple";
}

/// A level at which readings end is no multiple of anything.
TEST(FirstOrderGainTest, AsItStandsItGainsWhatItDoesToTheWhole) {
  const Case one;
  const BesideFittedNumbers beside = one.beside(3.0);
  const auto gained_by = [&](double times) {
    return beside.sums_of(times * one.change).gain_as_it_stands().chi_square;
  };
  const double all = beside.residuals().squaredNorm();
  EXPECT_NEAR(gained_by(3.0), all, 1e-12);
  EXPECT_NEAR(gained_by(1.0), all * (1.0 - 4.0 / 9.0), 1e-12) << "two thirds are left";
  EXPECT_EQ(gained_by(7.0), 0.0) << "χ² rises";
  EXPECT_NEAR(beside.left(beside.residuals() + 3.0 * one.change).norm(), 0.0, 1e-12);
}

TEST(FirstOrderGainTest, BallsThatShareAnEffectAddUp) {
  const Case one;
  BesideFittedNumbers::Sums sums = one.beside(3.0).sums_of(one.change);
  sums += one.beside(-3.0).sums_of(one.change);
  EXPECT_NEAR(sums.gain().chi_square, 0.0, 1e-12)
      << "one ball lacks what the other has too much of";
}

}  // namespace
}  // namespace rebound
