#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/problem/mechanisms.hpp"

/// A smooth factor given by its values at points, for a dependence whose formula is not known.
///
///   1 + g(u/u_end),   g through g_0 … g_5 at u/u_end = 0, 1/5 … 1, constant beyond
///
///   u      what the factor depends on        u_end  the last point, 0: no curve
///
/// Between points g is the cubic whose slopes at them are central differences (one-sided at the
/// ends): smooth to its first derivative, and local, so that one point does not move another end.
/// Valid:   u ≥ 0.
/// Limit:   all values zero give exactly 1 -> test FactorCurveTest.NothingIsOne; a straight line
///          comes out straight -> test FactorCurveTest.ALineStaysALine.
/// Source:  cubic Hermite interpolation with finite-difference slopes, e.g. Fritsch & Carlson 1980,
///          without their limiter.
namespace rebound {

/// g alone.
inline double curve_value(const FactorCurve& curve, double u) {
  if (curve.end == 0.0) return 0.0;
  if (std::isnan(u)) return u;  // of a step that is refused: no place on the curve
  constexpr int last = static_cast<int>(FactorCurve::points) - 1;
  const double place = std::min(u / curve.end, 1.0) * last;
  const int i = std::min(static_cast<int>(place), last - 1);
  const double t = place - i;
  const auto value = [&](int k) { return curve.value[static_cast<std::size_t>(k)]; };
  const auto slope = [&](int k) {
    if (k == 0) return value(1) - value(0);
    if (k == last) return value(last) - value(last - 1);
    return 0.5 * (value(k + 1) - value(k - 1));
  };
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * value(i) + (t3 - 2.0 * t2 + t) * slope(i) +
         (3.0 * t2 - 2.0 * t3) * value(i + 1) + (t3 - t2) * slope(i + 1);
}

inline double curve_factor(const FactorCurve& curve, double u) {
  return 1.0 + curve_value(curve, u);
}

}  // namespace rebound
