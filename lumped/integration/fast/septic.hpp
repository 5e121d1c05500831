#pragma once

namespace rebound {

/// A value with its first three derivatives at one end of a step.
struct HermiteEnd {
  double value, slope, curvature, third;
};

/// Hermite polynomial of seventh degree on θ ∈ [0, 1] across a step h.
///
/// Error: eighth order in h -> test SepticTest.ReproducesSeventhDegree.
class Septic {
 public:
  Septic() = default;
  Septic(const HermiteEnd& start, const HermiteEnd& end, double h) {
    const double h2 = 0.5 * h * h, h3 = h * h * h * (1.0 / 6.0);
    c0_ = start.value;
    c1_ = h * start.slope;
    c2_ = h2 * start.curvature;
    c3_ = h3 * start.third;
    const double r0 = end.value - c0_ - c1_ - c2_ - c3_;
    const double r1 = h * end.slope - c1_ - 2.0 * c2_ - 3.0 * c3_;
    const double r2 = h2 * end.curvature - c2_ - 3.0 * c3_;
    const double r3 = h3 * end.third - c3_;
    c4_ = 35.0 * r0 - 15.0 * r1 + 5.0 * r2 - r3;
    c5_ = -84.0 * r0 + 39.0 * r1 - 14.0 * r2 + 3.0 * r3;
    c6_ = 70.0 * r0 - 34.0 * r1 + 13.0 * r2 - 3.0 * r3;
    c7_ = -20.0 * r0 + 10.0 * r1 - 4.0 * r2 + r3;
  }

  double value(double s) const {
    return c0_ + s * (c1_ + s * (c2_ + s * (c3_ + s * (c4_ + s * (c5_ + s * (c6_ + s * c7_))))));
  }
  /// d/dθ; divide by h for the derivative.
  double derivative(double s) const {
    return c1_ + s * (2.0 * c2_ +
                      s * (3.0 * c3_ +
                           s * (4.0 * c4_ + s * (5.0 * c5_ + s * (6.0 * c6_ + s * 7.0 * c7_)))));
  }
  /// d²/dθ².
  double second_derivative(double s) const {
    return 2.0 * c2_ + s * (6.0 * c3_ + s * (12.0 * c4_ +
                                             s * (20.0 * c5_ + s * (30.0 * c6_ + s * 42.0 * c7_))));
  }

 private:
  double c0_ = 0, c1_ = 0, c2_ = 0, c3_ = 0, c4_ = 0, c5_ = 0, c6_ = 0, c7_ = 0;
};

}  // namespace rebound
