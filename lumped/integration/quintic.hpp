#pragma once

namespace rebound {

/// A value with its first two derivatives at one end of a step.
struct HermiteEnd {
  double value, slope, curvature;
};

/// Quintic Hermite polynomial on θ ∈ [0, 1] across a step h.
///
/// Error: sixth order in h -> test QuinticTest.ReproducesFifthDegree.
class Quintic {
 public:
  Quintic(const HermiteEnd& start, const HermiteEnd& end, double h)
      : c0_(start.value), c1_(h * start.slope), c2_(0.5 * h * h * start.curvature) {
    const double rise = end.value - start.value - c1_ - c2_;
    const double slope = h * end.slope - c1_ - 2.0 * c2_;
    const double curvature = h * h * end.curvature - 2.0 * c2_;
    c3_ = 10.0 * rise - 4.0 * slope + 0.5 * curvature;
    c4_ = -15.0 * rise + 7.0 * slope - curvature;
    c5_ = 6.0 * rise - 3.0 * slope + 0.5 * curvature;
  }

  double value(double s) const {
    return c0_ + s * (c1_ + s * (c2_ + s * (c3_ + s * (c4_ + s * c5_))));
  }
  /// d/dθ; divide by h for the derivative.
  double derivative(double s) const {
    return c1_ + s * (2.0 * c2_ + s * (3.0 * c3_ + s * (4.0 * c4_ + s * 5.0 * c5_)));
  }

 private:
  double c0_, c1_, c2_, c3_, c4_, c5_;
};

}  // namespace rebound
