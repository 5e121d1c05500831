#pragma once

#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Traction that pulls the surface of a deformable ball to the plate; none at
/// the defaults.
///
///   T(g) = (2 w/r) (1 − g/r),  0 ≤ g ≤ r,      ∫ T dg = w
///
///   g  gap between surface and plate [m]     T  per area of the surface at rest [Pa]
struct AdhesiveTraction {
  double work = 0.0;   ///< w, work of adhesion [J/m²]
  double range = 0.0;  ///< r [m]; 0: choose, see fem/interface/adhesive_range.hpp

  bool acts() const { return work > 0.0; }
  double reach() const { return acts() ? range : 0.0; }  ///< gap beyond which there is no pull [m]

  static constexpr auto limits() {
    return std::tuple{
        Limit{&AdhesiveTraction::work, "work", "J/m^2", limit_of<&Mechanisms::adhesion>.range},
        Limit{&AdhesiveTraction::range, "range", "mm", at_least(0.0), 0.0}};
  }
  friend bool operator==(const AdhesiveTraction&, const AdhesiveTraction&) = default;
};

}  // namespace rebound
