#pragma once

#include <string>
#include <vector>

#include "fem/interface/material.hpp"
#include "fem/interface/moduli.hpp"

namespace rebound {

/// One Prony branch as shares of the instantaneous moduli.
struct RelaxingShare {
  double deviator = 0.0;         ///< g of μ₀ [-]
  double volume = 0.0;           ///< k of K₀ [-]; 0 where the deviator alone relaxes
  double relaxation_time = 0.0;  ///< τ [s]
};

/// One term of an energy of principal stretches, of the instantaneous state.
struct StretchCard {
  double shear = 0.0;     ///< μᵢ, Σ μᵢ = μ₀ [Pa]
  double exponent = 0.0;  ///< αᵢ [-]
  double beta = 0.0;      ///< βᵢ of a hyperfoam [-]
};

/// A material in the numbers that other codes ask for.
///
///   G(t) = μ₀ (1 − Σ gᵢ (1 − exp(−t/τᵢ))),   K(t) alike with kᵢ
///   instantaneous description: gᵢ = ratio, kᵢ = ratio or 0
///   long-term description:     gᵢ = r μ∞/μ₀, kᵢ = r K∞/K₀ or 0
///   C₁₀ + C₀₁ = μ₀/2,   D₁ = 2/K₀ of U = (J − 1)²/D₁
///
/// Limit: both descriptions of one solid give one card -> test SolidCardTest.BothDescriptionsAgree
struct SolidCard {
  ElasticModel elastic{};
  fem::Moduli instantaneous, long_term;
  std::vector<RelaxingShare> branches;
  double c10 = 0.0, c01 = 0.0;     ///< [Pa]; c01 of Mooney–Rivlin alone
  double d1 = 0.0;                 ///< [1/Pa]
  std::vector<StretchCard> terms;  ///< of Ogden and hyperfoam

  double relaxing_deviator() const;  ///< Σ g [-]
  double relaxing_volume() const;    ///< Σ k [-]
};

/// Errors: Error(bad_input) for a material out of range (fem/interface/check_material.hpp).
SolidCard solid_card(const Material& material);

}  // namespace rebound
