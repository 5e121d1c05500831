#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/mechanisms/factor_curve.hpp"
#include "lumped/problem/mechanisms.hpp"

/// A pull between ball and plate of which only its curves are known.
///
///   P/F_r = l(√(x/x_end)) + [u(√(x/x_max)) on the way back],   x ≥ 0
///   P/F_r = [l(0) + u(0)] [1 + b(√(gap/G))],                   0 ≤ gap < G, and nothing beyond
///
///   F_r    elastic force of the law at x_end [N]         G   where the pull ends [m]
///   l, u   pulls over F_r; u is zero at x_max, so that the force has no jump where the ball turns
///
/// Square roots put the points of the curves where the ball meets and leaves the plate. Contact
/// ends where the gap is G, so that contact time and rebound speed are those of a free ball.
///
/// Valid:   |x| < R; a pull that does not hold the ball for good.
/// Limit:   a constant l with nothing beyond takes no energy: it gives on the way in what it takes
///          on the way out -> test PullCurvesTest.AConstantPullTakesNoEnergy;
///          a pull P [1 − √(gap/G)] beyond the plate takes P G/3
///          -> test PullCurvesTest.APullBeyondThePlateTakesItsArea.
/// Errors:  Error(solver_failed) where the ball does not come off.
namespace rebound {

/// Pull over F_r at deflection x ≥ 0, with the largest so far.
inline double pull_in_contact(const PullCurves& curves, double x, double largest, double radius,
                              bool way_back) {
  const double depth = std::max(x, 0.0);
  double pull = curve_value(curves.contact, std::sqrt(depth / (curves.deflection_reach * radius)));
  if (way_back && largest > 0.0)
    pull += curve_value(curves.unloading, std::sqrt(std::min(depth / largest, 1.0)));
  return pull;
}

/// Pull over F_r at a gap beyond the plate.
inline double pull_beyond(const PullCurves& curves, double gap, double radius) {
  const double reach = curves.gap_reach * radius;
  if (gap >= reach) return 0.0;
  const double at_plate = curve_value(curves.contact, 0.0) + curve_value(curves.unloading, 0.0);
  return at_plate * curve_factor(curves.beyond, std::sqrt(gap / reach));
}

}  // namespace rebound
