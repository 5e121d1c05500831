#pragma once

#include "fem/materials/moduli.hpp"
#include "fem/materials/volumetric_law.hpp"

namespace rebound::fem {

/// A material to copy: it compiles, and says where each formula goes. It is the
/// least there can be, a fluid that resists its volume alone (μ = 0).
///
///   W_d = 0,   W_v = K/4 (J² − 1 − 2 ln J)
///
///   list every symbol with its unit here
///
/// Valid:   where?
/// Limit:   what does it reduce to, and which test shows it?
/// Caution: what will surprise?
/// Source:  author, title, section.
struct BlankMaterial {
  Moduli moduli;

  template <class T>
  Symmetric<T> deviatoric_stress(const Strain<T>& e) const {
    const T zero = 0.0 * e.jacobian;
    return {zero, zero, zero, zero};
  }
  template <class T>
  Symmetric<T> volumetric_stress(const Strain<T>& e) const {
    return stress_of_volume(e, moduli.bulk);
  }
  template <class T>
  T deviatoric_energy(const Strain<T>& e) const {
    return 0.0 * e.jacobian;
  }
  template <class T>
  T volumetric_energy(const Strain<T>& e) const {
    return energy_of_volume(e, moduli.bulk);
  }

  /// A(h) = K J² (tr F⁻¹h)² − K/2 (J² − 1) tr(F⁻¹h F⁻¹h), each term by its bound.
  template <class T>
  T stiffness_growth(const Strain<T>& e, const T& m) const {
    const T square = e.jacobian * e.jacobian;
    const T off = square < 1.0 ? T(1.0 - square) : T(square - 1.0);
    return m * (square + 0.5 * off);
  }
};

}  // namespace rebound::fem
