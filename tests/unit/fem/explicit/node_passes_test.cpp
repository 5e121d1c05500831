#include "fem/explicit/node_passes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

// Of every remainder that the strands may leave; bit for bit those of eight strands one by one,
// whatever this machine's registers.
TEST(NodePassesTest, SumsAreThoseOneByOne) {
  test::Random random(17);
  for (std::size_t nodes = 1; nodes < 12; ++nodes) {
    std::vector<double> weight(2 * nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      weight[2 * i] = weight[2 * i + 1] = random.between(0.5, 2.0);
    const auto b = random.vector(2 * nodes, 1.0);
    double squares[8] = {}, plain[8] = {};
    for (std::size_t i = 0; i < 2 * nodes; ++i) {
      const double weighted = weight[i] * b[i];
      plain[i % 8] += weighted;
      squares[i % 8] += weighted * b[i];
    }
    WeightedSums expected;
    for (std::size_t i = 0; i < 8; i += 2) {
      expected.squares += squares[i] + squares[i + 1];
      expected.axial += plain[i + 1];
    }
    const WeightedSums sums = weighted_sums(weight, b);
    EXPECT_EQ(sums.squares, expected.squares) << nodes;
    EXPECT_EQ(sums.axial, expected.axial) << nodes;
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
