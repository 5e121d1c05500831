#include "comparisons/inference/calibration/platen_modulus.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

constexpr PlatenTest core_a{.stiffness = 4.053e5,
                            .diameter = 66.2e-3,
                            .poisson_ratio = 0.4,
                            .shortest_travel = 0.5e-3,
                            .longest_travel = 2.5e-3};

TEST(PlatenModulusTest, WithoutCorrectionIsHertz) {
  // Total travel is shared by two contacts: κ of one contact is 2^1.5 κ.
  const double expected =
      0.75 * (1 - 0.16) * std::pow(2.0, 1.5) * core_a.stiffness / std::sqrt(0.5 * core_a.diameter);
  EXPECT_NEAR(modulus_from_platens_hertz(core_a) / expected, 1.0, 1e-12);
}

TEST(PlatenModulusTest, FiniteSphereIsStifferSoItsModulusIsLower) {
  // At a/R = 0.19 the two-platen coefficient takes 6 % off the approach, so
  // 9 % off the modulus that gives the same force.
  const double ratio = modulus_from_platens(core_a) / modulus_from_platens_hertz(core_a);
  EXPECT_GT(ratio, 0.90);
  EXPECT_LT(ratio, 0.93);
}

TEST(PlatenModulusTest, CorrectionVanishesWithTheTravel) {
  PlatenTest small = core_a;
  small.shortest_travel = 1e-9;
  small.longest_travel = 2e-9;
  EXPECT_NEAR(modulus_from_platens(small) / modulus_from_platens_hertz(small), 1.0, 1e-3);
}

TEST(PlatenModulusTest, RefusesWhatItHasNoCoefficientFor) {
  PlatenTest outside = core_a;
  outside.poisson_ratio = 0.1;
  const Error error = testing::refusal_of([&] { modulus_from_platens(outside); });
  EXPECT_EQ(error.location().key, "poisson_ratio");
  PlatenTest empty = core_a;
  empty.longest_travel = empty.shortest_travel;
  EXPECT_EQ(testing::refusal_of([&] { modulus_from_platens(empty); }).code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
