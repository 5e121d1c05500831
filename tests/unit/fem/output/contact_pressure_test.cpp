#include "fem/output/contact_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rebound::fem {
namespace {

/// Three cells side by side on the plate; their undersides may touch.
const std::vector<std::array<int, 4>> cells = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}};
const std::vector<std::array<double, 2>> position = {{0, 0}, {1, 0}, {2.5, 0}, {3, 0.5},
                                                     {0, 1}, {1, 1}, {2.5, 1}, {3, 1}};

TEST(ContactPressureTest, EdgesAreTheOpenSidesBetweenContactNodes) {
  EXPECT_EQ(contact_edges(cells, {0, 1, 2, 3}),
            (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}}));
  // Node 7 is on the outside too; 1 and 5 share a side of two cells.
  EXPECT_EQ(contact_edges(cells, {1, 5, 3, 7}), (std::vector<std::array<int, 2>>{{3, 7}}));
}

TEST(ContactPressureTest, UniformPressureIsFoundFromItsConsistentForces) {
  // Forces of 3 Pa on rings, by Simpson's rule on N_i 2π r, which is exact.
  ContactPressure pressure(contact_edges(cells, {0, 1, 2, 3}), position, 1.0);
  const std::vector<double> displacement = {0, 0, 0.2, 0, 0, 0, 0, -0.5, 0, 0, 0, 0, 0, 0, 0, 0};
  const double r[4] = {0, 1.2, 2.5, 3};
  double force[4] = {};
  for (int i = 0; i < 3; ++i) {
    const double length = r[i + 1] - r[i], middle = 0.5 * (r[i] + r[i + 1]);
    const double share = 3.0 * 2.0 * std::numbers::pi * length / 6.0;
    force[i] += share * (r[i] + 2.0 * middle);
    force[i + 1] += share * (2.0 * middle + r[i + 1]);
  }
  constexpr double span = 0.125;
  for (int i = 0; i < 4; ++i) pressure.add(i, span * force[i]);
  pressure.pass(span);
  const auto found = pressure.pressure(displacement);
  for (int node = 0; node < 4; ++node) EXPECT_NEAR(found[node], 3.0, 1e-13);
  for (int node = 4; node < 8; ++node) EXPECT_EQ(found[node], 0.0);
}

TEST(ContactPressureTest, IntegratesToTheForce) {
  ContactPressure pressure(contact_edges(cells, {0, 1, 2, 3}), position, 1e3);
  pressure.add(0, 2.0);
  pressure.add(1, 5.0);
  pressure.add(2, 0.5);
  pressure.pass(4.0);
  const std::vector<double> rest(16, 0.0);
  const auto p = pressure.pressure(rest);
  double force = 0.0;  // ∫ p 2π r ds, p and r linear along each edge
  for (int i = 0; i < 3; ++i) {
    const auto &a = position[i], &b = position[i + 1];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double middle = 0.25 * (p[i] + p[i + 1]) * (a[0] + b[0]);
    force += 2.0 * std::numbers::pi * length / 6.0 * (p[i] * a[0] + 4.0 * middle + p[i + 1] * b[0]);
  }
  EXPECT_NEAR(force, 7.5 / 4.0, 1e-13);
}

TEST(ContactPressureTest, ForgetsWhatIsOlderThanTheWindow) {
  ContactPressure pressure(contact_edges(cells, {0, 1, 2, 3}), position, 0.2);
  const std::vector<double> rest(16, 0.0);
  double largest = 0.0, smallest = 1e9;
  for (int step = 1; step <= 1000; ++step) {
    // Alternating impulses of mean 1 per 0.01 s.
    pressure.add(1, step % 2 ? 2.0 : 0.0);
    pressure.pass(0.01 * step);
    if (step < 40) continue;
    largest = std::max(largest, pressure.pressure(rest)[1]);
    smallest = std::min(smallest, pressure.pressure(rest)[1]);
  }
  EXPECT_LT(largest / smallest, 1.25);
  for (int step = 1001; step <= 1021; ++step) pressure.pass(0.01 * step);
  EXPECT_EQ(pressure.pressure(rest)[1], 0.0);
}

}  // namespace
}  // namespace rebound::fem
