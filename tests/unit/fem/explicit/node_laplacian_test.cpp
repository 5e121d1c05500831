#include "fem/explicit/node_laplacian.hpp"

#include <gtest/gtest.h>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

/// Every node the neighbour of every other: the longest reach before the first and behind the last.
/// This program surrounds arrays by NaN, so that a value read beside one is seen.
TEST(NodeLaplacianTest, ReachesOverBothEndsOfItsNodesAndNoFurther) {
  test::Random random(3);
  for (int nodes = 1; nodes <= 13; ++nodes) {
    std::vector<int> first{0};
    std::vector<NodeLaplacian::Neighbour> neighbours;
    for (int i = 0; i < nodes; ++i) {
      for (int j = 0; j < nodes; ++j)
        if (j != i) neighbours.push_back({.node = j, .mass = 1.0 + i * j});
      first.push_back(static_cast<int>(neighbours.size()));
    }
    NodeLaplacian laplacian(first, neighbours);
    const std::size_t values = 2 * static_cast<std::size_t>(nodes);
    const auto force = random.vector(values, 1.0), before = random.vector(values, 1.0);
    const std::vector<double> inverse_mass(values, 0.5);
    auto velocity = before;
    laplacian.kick(0.25, inverse_mass, force, velocity);
    const auto moving = laplacian.added_to(force, inverse_mass);
    for (std::size_t i = 0; i < values; ++i)
      EXPECT_EQ(velocity[i], before[i] - 0.25 * moving[i] * inverse_mass[i]) << nodes << ", " << i;

    const auto other = random.vector(values + 2 * NodeLaplacian::padding, 1.0);
    double sum = 0.0;
    for (int i = 0; i < nodes; ++i)
      for (int j = 0; j < i; ++j)
        for (int axis = 0; axis < 2; ++axis) {
          const int a = 2 * i + axis, b = 2 * j + axis;
          const double apart = before[a] - before[b], other_apart = other[a] - other[b];
          sum += (1.0 + i * j) * (apart * apart + other_apart * other_apart);
        }
    auto padded = before;
    padded.resize(values + 2 * NodeLaplacian::padding, 7.0);
    EXPECT_NEAR(laplacian.half_squares(padded, other), 0.5 * sum, 1e-12 * (1.0 + sum)) << nodes;
  }
}

}  // namespace
}  // namespace rebound::fem
