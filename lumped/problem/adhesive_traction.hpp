#pragma once

namespace rebound {

/// Traction that pulls the surface of a deformable ball to the plate; none at
/// the defaults.
///
///   T(g) = (2 w/r) (1 − g/r),  0 ≤ g ≤ r,      ∫ T dg = w
///
///   g  gap between surface and plate [m]     T  per area of the surface at rest [Pa]
struct AdhesiveTraction {
  double work = 0.0;   ///< w, work of adhesion [J/m²]
  double range = 0.0;  ///< r [m]; 0: choose, see fem/contact/adhesive_range.hpp

  bool acts() const { return work > 0.0; }
  double reach() const { return acts() ? range : 0.0; }  ///< gap beyond which there is no pull [m]

  friend bool operator==(const AdhesiveTraction&, const AdhesiveTraction&) = default;
};

}  // namespace rebound
