#pragma once

#include <vector>

namespace rebound {

/// Half the width, over the contact, that takes the ripple out of a mesh: 0.06 (300 / cells)^½, for
/// nodes of half the distance touch twice as often. Waves in the ball are longer than that on the
/// finer of two meshes, and come back with what it adds to the coarse one.
double ripple_width(int cells);

/// A contact force without the ripple of nodes that touch and leave one by one.
///
/// Local parabolas by least squares over ± w of the contact (Savitzky & Golay 1964), ± w/3 and
/// less at its ends:
///
///   bias    none for a parabola; (π/T)⁴ w⁴/280 of a half-sine of length T, 5e-6 at w = 0.06 T
///   ripple  that changes from instant to instant goes down to a fifth at w = 0.06
///
///   force   at equal steps from first touch to separation [N]
///
/// Valid:   a hundred instants and more.
/// Limit:   a parabola is returned as it is -> test ContactRippleTest.AParabolaIsReturned.
/// Caution: a load cell's reading on a plate that moves has no such ripple, and swings that are to
///          be seen: it is not for this.
std::vector<double> without_ripple(const std::vector<double>& force, double half_width);

}  // namespace rebound
