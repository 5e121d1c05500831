#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lumped/problem/names.hpp"
#include "lumped/problem/validity.hpp"

namespace rebound {

/// The stored energies of elastic_models.inc, per reference volume, with F the deformation
/// gradient, C = FᵀF, J = det F, I₁ = tr C, Ī₁ = J^(−2/3) I₁, Ī₂ = J^(−4/3) I₂, principal stretches
/// λₖ and λ̄ₖ = J^(−1/3) λₖ, Lamé constants μ, λ, bulk modulus K.
/// The list is in elastic_models.hpp.
enum class ElasticModel : int;

/// One term of the energies of principal stretches (Ogden, hyperfoam): its
/// shape. The modulus of the material sets the size of all terms together.
struct StretchTerm {
  double weight = 1.0;         ///< μᵢ/Σ μ up to a common factor, > 0 [-]
  double exponent = 2.0;       ///< αᵢ, not zero [-]
  std::optional<double> beta;  ///< βᵢ of a hyperfoam [-]; absent: ν/(1 − 2ν) of the material

  static constexpr auto limits() {
    return std::tuple{Limit{&StretchTerm::weight, "weight", "", above(0.0)},
                      Limit{&StretchTerm::exponent, "exponent", "", from_to(-50.0, 50.0)},
                      Limit{&StretchTerm::beta, "beta", "", above_up_to(-1.0 / 3.0, 100.0)}};
  }
  friend bool operator==(const StretchTerm&, const StretchTerm&) = default;
};

/// Terms that one law can have: the kernels hold them in plain arrays.
inline constexpr std::size_t most_stretch_terms = 6;

/// The state that modulus and Poisson ratio describe.
enum class ModulusBasis { instantaneous, long_term };
constexpr auto names_of(ModulusBasis) {
  return names_list<ModulusBasis>(
      {{"instantaneous", ModulusBasis::instantaneous}, {"long-term", ModulusBasis::long_term}});
}

/// What a branch relaxes: all of the stress (Poisson ratio constant), or the
/// deviator alone (bulk modulus constant).
enum class Relaxes { all, deviator };
constexpr auto names_of(Relaxes) {
  return names_list<Relaxes>({{"all", Relaxes::all}, {"deviator", Relaxes::deviator}});
}

/// One Prony branch.
///
/// `ratio` is the share gᵢ of the instantaneous modulus (Σ gᵢ < 1) when the
/// modulus is instantaneous, and branch over long-term modulus (any > 0) when
/// the modulus is long-term.
struct PronyBranch {
  double ratio = 0.0;            ///< [-]
  double relaxation_time = 0.0;  ///< [s]
  Relaxes relaxes = Relaxes::all;
  double rate_exponent =
      1.0;  ///< m: flow strain ∝ rate^m; other than 1 by the multiplicative split [-]
  double reference_strain =
      0.1;  ///< elastic strain at which relaxation_time holds when m is not 1 [-]

  /// A branch of ratio 0 carries nothing and its time says nothing: leave it out.
  static constexpr auto limits() {
    return std::tuple{
        Limit{&PronyBranch::ratio, "ratio", "", above(0.0)},
        Limit{&PronyBranch::relaxation_time, "relaxation_time", "ms", above(0.0)},
        Limit{&PronyBranch::rate_exponent, "rate_exponent", "", above_up_to(0.0, 10.0), 1.0},
        Limit{&PronyBranch::reference_strain, "reference_strain", "", above(0.0), 0.1}};
  }
  friend bool operator==(const PronyBranch&, const PronyBranch&) = default;
};

/// How branches act: by convolution of the second Piola–Kirchhoff stress, or by a
/// split F = Fₑ Fᵥ with an energy and a flow rule of their own.
enum class Relaxation { convolution, multiplicative };
constexpr auto names_of(Relaxation) {
  return names_list<Relaxation>(
      {{"convolution", Relaxation::convolution}, {"multiplicative", Relaxation::multiplicative}});
}

/// Everything within a distance of the centre, and what lies outside it.
struct RadialLayer {
  double from = 0.8;            ///< r/R where the layer begins [-]
  double modulus_factor = 1.0;  ///< all its moduli over those of the material [-]

  static constexpr auto limits() {
    return std::tuple{Limit{&RadialLayer::from, "from", "", from_to_below(0.0, 1.0)},
                      Limit{&RadialLayer::modulus_factor, "modulus_factor", "", above(0.0)}};
  }
  friend bool operator==(const RadialLayer&, const RadialLayer&) = default;
};

/// g of a factor 1 + g on the elastic stress, over the effective strain: linear between its values
/// at 0, 1/5 ... 1 of the reach, constant beyond.
struct StrainCurve {
  static constexpr std::size_t points = 6;
  std::array<double, points> value{};  ///< [-]
  double reach = 0.0;                  ///< strain at the last point; 0: no curve [-]

  friend bool operator==(const StrainCurve&, const StrainCurve&) = default;
};

/// m of a factor 1 + m on the elastic stress below the largest strain so far: linear between its
/// values where ε is 1 − (1 − k/5)² of it, k = 0 ... 4, and zero at the largest strain itself.
struct UnloadingCurve {
  static constexpr std::size_t points = 5;
  std::array<double, points> value{};  ///< [-]

  bool acts() const { return *this != UnloadingCurve{}; }
  friend bool operator==(const UnloadingCurve&, const UnloadingCurve&) = default;
};

/// Factors that strain puts on the elastic stress; see fem/materials/strain_factor.hpp.
struct StrainDependence {
  double stiffening = 0.0;     ///< a [-]
  double softening = 0.0;      ///< b, toward a plateau [-]
  double densification = 0.0;  ///< c [-]
  double mullins = 0.0;        ///< d, unloading below first loading [-]
  StrainCurve curve;           ///< without a formula; added to the others
  UnloadingCurve unloading;    ///< without a formula; added to Mullins softening

  bool remembers() const { return mullins > 0.0 || unloading.acts(); }

  static constexpr auto limits() {
    using S = StrainDependence;
    return std::tuple{Limit{&S::stiffening, "strain_stiffening", "", at_least(0.0), 0.0},
                      Limit{&S::softening, "strain_softening", "", from_to_below(0.0, 1.0), 0.0},
                      Limit{&S::densification, "densification", "", at_least(0.0), 0.0},
                      Limit{&S::mullins, "mullins", "", from_to(0.0, 1.0), 0.0}};
  }
  friend bool operator==(const StrainDependence&, const StrainDependence&) = default;
};

/// Isotropic viscoelastic solid: hyperelastic, with Prony branches.
struct Material {
  ElasticModel elastic{};       ///< the first of the list: neo-Hookean
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;   ///< [-], of the same state as the modulus
  ModulusBasis modulus = ModulusBasis::instantaneous;
  std::vector<PronyBranch> branches;
  double second_share = 0.0;       ///< C₀₁/(C₁₀ + C₀₁) of Mooney–Rivlin [-]
  std::vector<StretchTerm> terms;  ///< of Ogden and hyperfoam
  Relaxation relaxation = Relaxation::convolution;
  double retardation_time = 0.0;  ///< Kelvin–Voigt viscous stress over the instantaneous moduli [s]
  StrainDependence strain;
  std::vector<RadialLayer> layers;  ///< the last that begins inside a point's radius holds

  static constexpr auto limits() {
    return std::tuple{
        Limit{&Material::youngs_modulus, "youngs_modulus", "MPa", above(0.0)},
        Limit{&Material::poisson_ratio, "poisson_ratio", "", above_up_to(-1.0, 0.499), std::nullopt,
              "above, the stable step and the bulk modulus go to the limit of an incompressible "
              "body"},
        Limit{&Material::second_share, "second_share", "", from_to(0.0, 1.0)},
        Limit{&Material::retardation_time, "retardation_time", "us", at_least(0.0), 0.0}};
  }
  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace rebound
