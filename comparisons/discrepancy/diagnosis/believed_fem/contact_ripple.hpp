#pragma once

#include <vector>

namespace rebound {

/// A contact force without the ripple of nodes that touch and leave one by one.
///
/// Local parabolas by least squares over ± 6 % of the contact (Savitzky & Golay 1964), ± 2 % and
/// less at its ends:
///
///   bias    none for a parabola; (π/T)⁴ w⁴/280 of a half-sine of length T, 5e-6 at w = 0.06 T
///   ripple  that changes from instant to instant goes down to a fifth
///
///   force   at equal steps from first touch to separation [N]
///
/// Valid:   a hundred instants and more.
/// Limit:   a parabola is returned as it is -> test ContactRippleTest.AParabolaIsReturned.
/// Caution: a load cell's reading on a plate that moves has no such ripple, and swings that are to
/// be
///          seen: it is not for this.
std::vector<double> without_ripple(const std::vector<double>& force);

}  // namespace rebound
