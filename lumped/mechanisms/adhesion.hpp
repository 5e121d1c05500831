#pragma once

#include <numbers>

namespace rebound {

/// Adhesion of a stiff sphere: a constant pull while in contact, and a neck that tears.
///
///   −P,                P = 2π R γ          in contact
///   −P (1 − g/G)²,     0 ≤ g < G           after it, g the gap
///
///   γ   work of adhesion [J/m²]     R   radius [m]     G   reach of the neck [m]; 0: none
///
/// The pull is there at first touch, before the ball pushes: a record begins with a dip. It stays
/// until the rest of the force is zero. There contact ends, or a neck holds on until the gap is G.
/// No neck forms before touch, so that it takes P G/3.
/// Valid:   DMT limit: pull small against the peak force.
/// Limit:   force at touch and at the end is −2π R γ; γ → 0 is none; what a constant pull gives on
///          the way in it takes on the way out, so that restitution stays
///          -> test AdhesionTest.PullsFromTouchToPullOffAndTakesNoEnergy;
///          a neck takes P G/3 -> test AdhesionTest.ANeckTakesItsArea.
/// Caution: JKR balls pull off at 3/4 of this.
/// Source:  B. V. Derjaguin, V. M. Muller & Yu. P. Toporov, J. Colloid Interface Sci. 53 (1975)
///          314. Beyond the plate: Derjaguin's approximation, Kolloid-Z. 69 (1934) 155, of a
///          traction that falls in a straight line.
inline double pull_off_force(double work_of_adhesion, double radius) {
  return 2.0 * std::numbers::pi * radius * work_of_adhesion;
}

/// Share of the pull that a neck of this reach [m] has left at a gap [m].
inline double neck_share(double gap, double reach) {
  if (gap >= reach) return 0.0;
  const double left = 1.0 - gap / reach;
  return left * left;
}

}  // namespace rebound
