#pragma once

#include <algorithm>
#include <numbers>

namespace rebound {

/// Adhesion of a stiff sphere: a constant pull while in contact.
///
///   −P w(r),  P = 2π R γ,  w(r) = r³ (10 − 15 r + 6 r²),  r = F_e(x_max)/(0.01 F_peak) up to 1
///
///   γ        work of adhesion [J/m²]     R   radius [m]
///   x_max    largest deflection so far [m]
///   F_peak   elastic force where the elastic energy is the kinetic energy brought [N]
///
/// So the pull grows over the first hundredth of the peak force and then
/// stays until pull-off: contact ends where the rest of the force is zero and
/// the total is −P. w has two continuous derivatives; nothing jumps.
/// Valid:   DMT limit: pull small against the peak force.
/// Limit:   force at the end is −2π R γ; γ → 0 is none
///          -> test AdhesionTest.EndsAtPullOff.
/// Caution: JKR balls pull off at 3/4 of this and with a neck; the ramp, not
///          the pull, dissipates, and little.
/// Source:  Derjaguin, Muller & Toporov 1975.
inline double pull_off_force(double work_of_adhesion, double radius) {
  return 2.0 * std::numbers::pi * radius * work_of_adhesion;
}

/// Share of the pull that acts when the elastic force has been `largest_force`.
inline double adhesion_ramp(double largest_force, double peak_force) {
  const double r = std::clamp(largest_force / (0.01 * peak_force), 0.0, 1.0);
  return r * r * r * (10.0 + r * (-15.0 + 6.0 * r));
}

}  // namespace rebound
