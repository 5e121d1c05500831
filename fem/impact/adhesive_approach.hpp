#pragma once

#include <algorithm>
#include <cmath>

#include "fem/interface/fem_problem.hpp"

namespace rebound::fem {

/// Where and how fast a ball begins so that it touches at its speed, although the plate pulls
/// before.
///
///   v_g² = v² − 2 (V(g)/m + G g),   g = r, or less where v_g would not be real
///
///   v  speed at first touch [m/s]       V  potential of adhesion against that at touch [J]
///   g  height over first touch [m]      G  gravity [m/s²]       r  range of the traction [m]
///
/// A ball that began at touch would feel the whole pull at once, and ring from it. One so slow
/// that the pull alone makes it faster is let go at rest, nearer.
///
/// v is the speed that the ball brings to touch undeformed. It is what restitution is taken from,
/// since it says what energy is brought; the pole bulges towards the plate and touches earlier,
/// at a centre of mass slower by 0.5 % at 0.5 m/s and 20 J/m².
/// Limit:   adhesion costs what leaving its range costs -> test AdhesionImpact.NoShockAtTouch
struct AdhesiveApproach {
  double height = 0.0;  ///< [m]
  double speed = 0.0;   ///< there, towards the plate [m/s]
};

/// `potential(height)` is V of the undeformed ball.
template <class Potential>
AdhesiveApproach adhesive_approach(const FemProblem& problem, double range,
                                   const Potential& potential) {
  const double v = problem.impact.speed;
  const auto speed_squared = [&](double height) {
    return v * v - 2.0 * (potential(height) / problem.sphere.mass + problem.gravity * height);
  };
  if (speed_squared(range) >= 0.0)
    return {.height = range, .speed = std::sqrt(speed_squared(range))};
  double low = 0.0, high = range;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (speed_squared(middle) > 0.0 ? low : high) = middle;
  }
  return {.height = low, .speed = std::sqrt(std::max(0.0, speed_squared(low)))};
}

}  // namespace rebound::fem
