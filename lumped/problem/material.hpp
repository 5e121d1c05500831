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
  double rate_exponent = 1.0;     ///< m: flow strain ∝ rate^m; other than 1 by the multiplicative split [-]
  double reference_strain = 0.1;  ///< elastic strain at which relaxation_time holds when m is not 1 [-]

  friend bool operator==(const PronyBranch&, const PronyBranch&) = default;
};

/// How branches act: by convolution of the second Piola–Kirchhoff stress, or by a
/// split F = Fₑ Fᵥ with an energy and a flow rule of their own.
enum class Relaxation { convolution, multiplicative };

/// Everything within a distance of the centre, and what lies outside it.
struct RadialLayer {
  double from = 0.8;            ///< r/R where the layer begins [-]
  double modulus_factor = 1.0;  ///< all its moduli over those of the material [-]

  friend bool operator==(const RadialLayer&, const RadialLayer&) = default;
};

/// Factors that strain puts on the elastic stress; see fem/materials/strain_factor.hpp.
struct StrainDependence {
  double stiffening = 0.0;     ///< a [-]
  double softening = 0.0;      ///< b, toward a plateau [-]
  double densification = 0.0;  ///< c [-]
  double mullins = 0.0;        ///< d, unloading below first loading [-]

  friend bool operator==(const StrainDependence&, const StrainDependence&) = default;
};

/// Isotropic viscoelastic solid: hyperelastic, with Prony branches.
struct Material {
  ElasticModel elastic = ElasticModel::neo_hookean;
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-], of the same state as the modulus
  ModulusBasis modulus = ModulusBasis::instantaneous;
  std::vector<PronyBranch> branches;
  double second_share = 0.0;       ///< C₀₁/(C₁₀ + C₀₁) of Mooney–Rivlin [-]
  std::vector<StretchTerm> terms;  ///< of Ogden and hyperfoam
  Relaxation relaxation = Relaxation::convolution;
  double retardation_time = 0.0;   ///< Kelvin–Voigt viscous stress over the instantaneous moduli [s]
  StrainDependence strain;
  std::vector<RadialLayer> layers; ///< the last that begins inside a point's radius holds

  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace rebound
