#include "comparisons/accuracy/numerical_error/grid_convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rebound {
namespace {

TEST(GridConvergenceTest, PublishedExample) {
  // Slater, "Examining Spatial (Grid) Convergence", NPARC Alliance: pressure
  // recovery of an inlet on three grids.
  const GridError error = grid_convergence({.coarse = 0.96178, .medium = 0.96854, .fine = 0.97050});
  EXPECT_EQ(error.basis, ErrorBasis::grid_convergence);
  EXPECT_NEAR(error.observed_order.value(), 1.786170, 1e-6);
  EXPECT_NEAR(error.uncertainty / 0.97050, 0.00103083, 1e-8);
  // 1.25 times the distance to the extrapolated value.
  EXPECT_NEAR(0.97050 + error.uncertainty / 1.25, 0.971300, 1e-6);
}

TEST(GridConvergenceTest, CoversTheLimitOfAnyPowerUpToTheCells) {
  for (const double order : {0.5, 0.7, 1.0, 1.5, 2.0})
    for (const double sign : {-1.0, 1.0}) {
      const auto value = [&](double size) { return 3.0 + sign * 0.1 * std::pow(size, order); };
      const GridError error = grid_convergence({value(4), value(2), value(1)});
      EXPECT_NEAR(error.observed_order.value(), order, 1e-12);
      EXPECT_NEAR(error.uncertainty, 1.25 * 0.1, 1e-12) << order;
    }
}

TEST(GridConvergenceTest, AnOrderAboveTheCellsIsNotBelieved) {
  const GridError error = grid_convergence({1.0, 1.006, 1.007});
  EXPECT_NEAR(error.observed_order.value(), std::log2(6.0), 1e-9);
  EXPECT_EQ(error.basis, ErrorBasis::grid_convergence);
  EXPECT_NEAR(error.uncertainty, 1.25 * 0.001 / 3.0, 1e-12);
}

TEST(GridConvergenceTest, NothingIsExtrapolatedAboveThirdOrder) {
  const GridError error = grid_convergence({1.0, 1.064, 1.065});
  EXPECT_NEAR(error.observed_order.value(), 6.0, 1e-9);
  EXPECT_EQ(error.basis, ErrorBasis::spread);
  EXPECT_NEAR(error.uncertainty, 0.016, 1e-12);
}

TEST(GridConvergenceTest, WhereStepsDoNotShrinkTheSpreadCounts) {
  for (const GridTriple& values :
       {GridTriple{1.0, 1.01, 1.03}, GridTriple{1.0, 1.03, 1.01}, GridTriple{1.0, 1.02, 1.04}}) {
    const GridError error = grid_convergence(values);
    EXPECT_EQ(error.basis, ErrorBasis::spread);
    EXPECT_GE(error.uncertainty, std::abs(values.fine - values.medium));
  }
  // Agreement of the two finest by accident is not believed.
  EXPECT_NEAR(grid_convergence({1.0, 1.04, 1.04}).uncertainty, 0.01, 1e-12);
  EXPECT_EQ(grid_convergence({1.0, 1.0, 1.0}).uncertainty, 0.0);
}

TEST(GridConvergenceTest, ScatterIsTheNoise) {
  EXPECT_NEAR(scatter_about_parabola({9.0, 4.0, 1.0, 0.0, 1.0}), 0.0, 1e-14);
  std::mt19937_64 engine(5);
  std::normal_distribution<double> noise(0.0, 0.3);
  double square = 0.0;
  constexpr int draws = 20000;
  for (int draw = 0; draw < draws; ++draw) {
    std::array<double, 5> values;
    for (int i = 0; i < 5; ++i) values[i] = 2.0 - 0.7 * i + 0.2 * i * i + noise(engine);
    const double s = scatter_about_parabola(values);
    square += s * s / draws;
  }
  EXPECT_NEAR(std::sqrt(square), 0.3, 0.005);
}

}  // namespace
}  // namespace rebound
