#pragma once

#include <numbers>

namespace rebound {

/// Adhesion of a stiff sphere: a constant pull while in contact.
///
///   −P,  P = 2π R γ
///
///   γ   work of adhesion [J/m²]     R   radius [m]
///
/// The pull is there at first touch, before the ball pushes: a record begins with a dip. It stays
/// until pull-off: contact ends where the rest of the force is zero and the total is −P.
/// Valid:   DMT limit: pull small against the peak force, and no reach beyond the plate.
/// Limit:   force at touch and at the end is −2π R γ; γ → 0 is none; what it gives on the way in it
///          takes on the way out, so that restitution stays
///          -> test AdhesionTest.PullsFromTouchToPullOffAndTakesNoEnergy.
/// Caution: JKR balls pull off at 3/4 of this and with a neck, which takes energy.
/// Source:  B. V. Derjaguin, V. M. Muller & Yu. P. Toporov, J. Colloid Interface Sci. 53 (1975)
///          314.
inline double pull_off_force(double work_of_adhesion, double radius) {
  return 2.0 * std::numbers::pi * radius * work_of_adhesion;
}

}  // namespace rebound
