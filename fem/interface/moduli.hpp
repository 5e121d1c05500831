#pragma once

namespace rebound::fem {

/// Moduli of an isotropic solid.
///
///   μ = E / (2 (1 + ν)),   K = E / (3 (1 − 2ν))
struct Moduli {
  double shear = 0.0;  ///< μ [Pa]
  double bulk = 0.0;   ///< K [Pa]

  static constexpr Moduli from_youngs(double youngs_modulus, double poisson_ratio) {
    return {youngs_modulus / (2.0 * (1.0 + poisson_ratio)),
            youngs_modulus / (3.0 * (1.0 - 2.0 * poisson_ratio))};
  }
};

}  // namespace rebound::fem
