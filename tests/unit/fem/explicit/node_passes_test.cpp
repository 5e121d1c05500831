#include "fem/explicit/node_passes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

// Of every remainder that the strands may leave.
TEST(NodePassesTest, SumsAreThoseOneByOne) {
  test::Random random(17);
  for (std::size_t nodes = 1; nodes < 12; ++nodes) {
    std::vector<double> weight(2 * nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      weight[2 * i] = weight[2 * i + 1] = random.between(0.5, 2.0);
    const auto b = random.vector(2 * nodes, 1.0);
    double squares = 0.0, axial = 0.0;
    for (std::size_t i = 0; i < 2 * nodes; ++i) squares += weight[i] * b[i] * b[i];
    for (std::size_t i = 1; i < 2 * nodes; i += 2) axial += weight[i] * b[i];
    const WeightedSums sums = weighted_sums(weight, b);
    EXPECT_NEAR(sums.squares, squares, 1e-14 * squares) << nodes;
    EXPECT_NEAR(sums.axial, axial, 1e-14 * squares) << nodes;
  }
}

TEST(NodePassesTest, AddsScaledToEveryValue) {
  test::Random random(19);
  for (std::size_t size = 1; size < 40; ++size) {
    const auto before = random.vector(size, 1.0), b = random.vector(size, 1.0);
    auto a = before;
    add_scaled(a, 0.3, b);
    for (std::size_t i = 0; i < size; ++i) EXPECT_DOUBLE_EQ(a[i], before[i] + 0.3 * b[i]) << size;
  }
}

}  // namespace
}  // namespace rebound::fem
