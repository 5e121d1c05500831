#pragma once

#include "fem/materials/moduli.hpp"
#include "lumped/problem/material.hpp"

namespace rebound::fem {

inline constexpr int largest_term_count = 6;

/// Terms of an energy of principal stretches; plain arrays, for kernels.
struct StretchTerms {
  int count = 0;
  double shear[largest_term_count] = {};     ///< μᵢ [Pa], Σ μᵢ = μ
  double exponent[largest_term_count] = {};  ///< αᵢ [-], not zero
  double beta[largest_term_count] = {};      ///< βᵢ [-], hyperfoam alone
};

/// What the elastic law of a kernel is made from.
struct ElasticConstants {
  ElasticModel model = ElasticModel::neo_hookean;
  Moduli moduli;              ///< at small strain
  double second_share = 0.0;  ///< C₀₁/(C₁₀ + C₀₁) of Mooney–Rivlin [-]
  StretchTerms terms;         ///< of Ogden and hyperfoam
};

}  // namespace rebound::fem
