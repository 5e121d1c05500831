#pragma once

#include <optional>
#include <vector>

namespace rebound {

/// Energy per reference volume, with F the deformation gradient, C = FᵀF,
/// J = det F, I₁ = tr C, Ī₁ = J^(−2/3) I₁, Ī₂ = J^(−4/3) I₂, principal stretches
/// λₖ and λ̄ₖ = J^(−1/3) λₖ, Lamé constants μ, λ, bulk modulus K.
enum class ElasticModel {
  neo_hookean,            ///< μ/2 (I₁ − 3 − 2 ln J) + λ/2 (ln J)²
  neo_hookean_isochoric,  ///< μ/2 (Ī₁ − 3) + K/2 (J − 1)²
  mooney_rivlin,          ///< C₁₀ (Ī₁ − 3) + C₀₁ (Ī₂ − 3) + K/4 (J² − 1 − 2 ln J)
  ogden,                  ///< Σ (2μᵢ/αᵢ²) (Σₖ λ̄ₖ^αᵢ − 3) + K/4 (J² − 1 − 2 ln J)
  hyperfoam,              ///< Σ (2μᵢ/αᵢ²) [Σₖ λₖ^αᵢ − 3 + (J^(−αᵢβᵢ) − 1)/βᵢ]
};

/// One term of the energies of principal stretches (Ogden, hyperfoam): its
/// shape. The modulus of the material sets the size of all terms together.
struct StretchTerm {
  double weight = 1.0;         ///< μᵢ/Σ μ up to a common factor, > 0 [-]
  double exponent = 2.0;       ///< αᵢ, not zero [-]
  std::optional<double> beta;  ///< βᵢ of a hyperfoam [-]; absent: ν/(1 − 2ν) of the material

  friend bool operator==(const StretchTerm&, const StretchTerm&) = default;
};

/// The state that modulus and Poisson ratio describe.
enum class ModulusBasis { instantaneous, long_term };

/// What a branch relaxes: all of the stress (Poisson ratio constant), or the
/// deviator alone (bulk modulus constant).
enum class Relaxes { all, deviator };

/// One Prony branch.
///
/// `ratio` is the share gᵢ of the instantaneous modulus (Σ gᵢ < 1) when the
/// modulus is instantaneous, and branch over long-term modulus (any > 0) when
/// the modulus is long-term.
struct PronyBranch {
  double ratio = 0.0;            ///< [-]
  double relaxation_time = 0.0;  ///< [s]
  Relaxes relaxes = Relaxes::all;

  friend bool operator==(const PronyBranch&, const PronyBranch&) = default;
};

/// Isotropic viscoelastic solid: hyperelastic, with Prony branches acting on
/// the second Piola–Kirchhoff stress by convolution.
struct Material {
  ElasticModel elastic = ElasticModel::neo_hookean;
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-], of the same state as the modulus
  ModulusBasis modulus = ModulusBasis::instantaneous;
  std::vector<PronyBranch> branches;
  double second_share = 0.0;       ///< C₀₁/(C₁₀ + C₀₁) of Mooney–Rivlin [-]
  std::vector<StretchTerm> terms;  ///< of Ogden and hyperfoam

  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace rebound
