#pragma once

#include <vector>

namespace rebound {

/// Energy per reference volume, with F the deformation gradient, C = FᵀF,
/// J = det F, I₁ = tr C, Ī₁ = J^(−2/3) I₁, Lamé constants μ, λ, bulk modulus K.
enum class ElasticModel {
  neo_hookean,            ///< μ/2 (I₁ − 3 − 2 ln J) + λ/2 (ln J)²
  neo_hookean_isochoric,  ///< μ/2 (Ī₁ − 3) + K/2 (J − 1)²
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

  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace rebound
