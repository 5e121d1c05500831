#pragma once

#include <vector>

namespace rebound {

/// How fast a contact force may change within a contact.
enum class ForceShape {
  smooth,  ///< as the contact grows and shrinks
  sharp  ///< with a step or a kink: a pull at first touch, a loss that begins at the turning point
};

/// Half the width, over the contact, that takes the ripple out of a mesh: 0.15 (300 / cells)^½, for
/// nodes of half the distance touch twice as often; 0.06 of a force that is sharp. What a width
/// rounds off on the coarse of two meshes comes back with what the finer one adds, as it is where
/// both were compared.
double ripple_width(int cells, ForceShape shape);

/// A contact force without the ripple of nodes that touch and leave one by one.
///
/// Local parabolas by least squares over ± w of the contact (Savitzky & Golay 1964), ± w/3 and
/// less at its ends:
///
///   bias    none for a parabola; (π/T)⁴ w⁴/280 of a half-sine of length T, 5e-6 at w = 0.06 T,
///   2e-4 at 0.15 T ripple  that changes from instant to instant goes down to a fifth at w = 0.06
///
///   force   at equal steps from first touch to separation [N]
///
/// Valid:   a hundred instants and more.
/// Limit:   a parabola is returned as it is -> test ContactRippleTest.AParabolaIsReturned.
/// Caution: a load cell's reading on a plate that moves has no such ripple, and swings that are to
///          be seen: it is not for this.
std::vector<double> without_ripple(const std::vector<double>& force, double half_width);

}  // namespace rebound
