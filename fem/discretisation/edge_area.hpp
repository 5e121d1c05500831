#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace rebound::fem {

/// ∫ 2πR N ds of both ends of a straight edge turned about the axis [m²], N linear:
/// π L/3 (2 r_a + r_b) and π L/3 (r_a + 2 r_b).
inline std::array<double, 2> edge_areas(const std::array<double, 2>& a,
                                        const std::array<double, 2>& b) {
  const double third = std::numbers::pi * std::hypot(b[0] - a[0], b[1] - a[1]) / 3.0;
  return {third * (2.0 * a[0] + b[0]), third * (a[0] + 2.0 * b[0])};
}

}  // namespace rebound::fem
