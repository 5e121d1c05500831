#include "comparisons/discrepancy/diagnosis/believed_fem/contact_ripple.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rebound {
namespace {

constexpr int instants = 401;

template <class Force>
std::vector<double> sampled(const Force& force) {
  std::vector<double> column;
  for (int i = 0; i < instants; ++i) column.push_back(force(i / (instants - 1.0)));
  return column;
}

TEST(ContactRippleTest, AParabolaIsReturned) {
  const auto parabola = sampled([](double s) { return 3000.0 * s * (1.0 - s); });
  const auto smooth = without_ripple(parabola, ripple_width(300));
  for (std::size_t i = 0; i < parabola.size(); ++i) EXPECT_NEAR(smooth[i], parabola[i], 1e-9);
}

TEST(ContactRippleTest, AContactKeepsItsForce) {
  const auto force =
      sampled([](double s) { return 3000.0 * std::pow(std::sin(std::numbers::pi * s), 1.5); });
  const auto smooth = without_ripple(force, ripple_width(300));
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_NEAR(smooth[i], force[i], 3.0) << i;
}

TEST(ContactRippleTest, RippleGoesDownToAFifth) {
  const auto force = sampled([](double s) { return 3000.0 * std::sin(std::numbers::pi * s); });
  auto rippled = force;
  for (std::size_t i = 0; i < rippled.size(); ++i) rippled[i] += i % 2 == 0 ? 30.0 : -30.0;
  const auto smooth = without_ripple(rippled, ripple_width(300));
  double sum = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) sum += std::pow(smooth[i] - force[i], 2);
  EXPECT_LT(std::sqrt(sum / instants), 30.0 / 5.0);
}

TEST(ContactRippleTest, AFinerMeshKeepsShorterWaves) {
  const auto force = sampled([](double s) {
    return 3000.0 * std::sin(std::numbers::pi * s) + 60.0 * std::sin(16.0 * std::numbers::pi * s);
  });
  const auto away = [&](int cells) {
    const auto smooth = without_ripple(force, ripple_width(cells));
    double largest = 0.0;
    for (std::size_t i = 50; i + 50 < force.size(); ++i)
      largest = std::max(largest, std::abs(smooth[i] - force[i]));
    return largest;
  };
  EXPECT_GT(away(300), 10.0);
  EXPECT_LT(away(1200), 3.0);
}

}  // namespace
}  // namespace rebound
