#pragma once

#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// Volumetric part of the isochoric laws that need a stiff floor.
///
///   W_v = K/4 (J² − 1 − 2 ln J),   S_v = K/2 (J² − 1) C⁻¹
///
/// Convex in J, infinite as J → 0 and J → ∞, where (J − 1)² stays finite.
/// Source: Simo & Taylor 1982; Holzapfel, Nonlinear Solid Mechanics (2000), §6.5.
template <class T>
inline Symmetric<T> stress_of_volume(const Strain<T>& e, double bulk) {
  const T factor = 0.5 * bulk * (e.jacobian * e.jacobian - 1.0);
  return {factor * e.inverse.rr, factor * e.inverse.zz, factor * e.inverse.tt,
          factor * e.inverse.rz};
}

template <class T>
inline T energy_of_volume(const Strain<T>& e, double bulk) {
  return 0.25 * bulk * (e.jacobian * e.jacobian - 1.0 - 2.0 * e.log_jacobian);
}

}  // namespace rebound::fem
