#pragma once

#include <array>

namespace rebound::fem {

inline constexpr int quadratic_nodes = 9;   ///< corners, mid-sides, centre
inline constexpr int quadratic_points = 9;  ///< 3×3 Gauss points

/// Values and slopes of the nine shape functions of the biquadratic cell at
/// (ξ, η) in [−1, 1]²: corners counter-clockwise from (−,−), the middles of the
/// sides that follow them, the centre.
///
///   N = L_a(ξ) L_b(η),   L₋(s) = s (s − 1)/2,  L₀(s) = 1 − s²,  L₊(s) = s (s + 1)/2
///
/// Limit: N_i is one at its own node, zero at the others -> test QuadraticBodyTest
struct QuadraticShapes {
  std::array<double, quadratic_nodes> value{};
  std::array<std::array<double, 2>, quadratic_nodes> slope{};  ///< ∂/∂ξ, ∂/∂η

  constexpr QuadraticShapes(double xi, double eta) {
    constexpr int place[quadratic_nodes][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0},
                                               {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    const double lx[3] = {0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)};
    const double ly[3] = {0.5 * eta * (eta - 1.0), 1.0 - eta * eta, 0.5 * eta * (eta + 1.0)};
    const double dx[3] = {xi - 0.5, -2.0 * xi, xi + 0.5};
    const double dy[3] = {eta - 0.5, -2.0 * eta, eta + 0.5};
    for (int i = 0; i < quadratic_nodes; ++i) {
      const int a = place[i][0], b = place[i][1];
      value[i] = lx[a] * ly[b];
      slope[i] = {dx[a] * ly[b], lx[a] * dy[b]};
    }
  }
};

}  // namespace rebound::fem
