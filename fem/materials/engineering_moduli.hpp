#pragma once

#include "fem/materials/moduli.hpp"

namespace rebound::fem {

/// E = 9 K μ/(3 K + μ) [Pa].
inline double youngs_modulus(const Moduli& moduli) {
  return 9.0 * moduli.bulk * moduli.shear / (3.0 * moduli.bulk + moduli.shear);
}

/// E* = E/(1 − ν²), ν = E/(2 μ) − 1: what a contact with a rigid plate feels [Pa].
inline double plane_strain_modulus(const Moduli& moduli) {
  const double youngs = youngs_modulus(moduli);
  const double poisson = youngs / (2.0 * moduli.shear) - 1.0;
  return youngs / (1.0 - poisson * poisson);
}

}  // namespace rebound::fem
