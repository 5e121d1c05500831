#pragma once

#include "fem/interface/material.hpp"
#include "fem/interface/moduli.hpp"

namespace rebound::fem {

/// Terms of an energy of principal stretches; plain arrays, for kernels.
struct StretchTerms {
  int count = 0;
  double shear[most_stretch_terms] = {};     ///< μᵢ [Pa], Σ μᵢ = μ
  double exponent[most_stretch_terms] = {};  ///< αᵢ [-], not zero
  double beta[most_stretch_terms] = {};      ///< βᵢ [-], hyperfoam alone
};

/// What the elastic law of a kernel is made from.
struct ElasticConstants {
  ElasticModel model{};
  Moduli moduli;              ///< at small strain
  double second_share = 0.0;  ///< C₀₁/(C₁₀ + C₀₁) of Mooney–Rivlin [-]
  StretchTerms terms;         ///< of Ogden and hyperfoam
};

}  // namespace rebound::fem
