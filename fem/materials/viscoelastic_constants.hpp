#pragma once

#include <vector>

#include "fem/interface/material.hpp"
#include "fem/interface/moduli.hpp"
#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/inelastic_constants.hpp"

namespace rebound::fem {

/// One Prony branch in terms of the instantaneous stress it is driven by:
/// Q̇ + Q/τ = d/dt (g_d S_d + g_v S_v).
struct BranchConstants {
  double deviatoric_share = 0.0;  ///< g_d [-]
  double volumetric_share = 0.0;  ///< g_v [-], zero when the branch relaxes the deviator alone
  double relaxation_time = 0.0;   ///< τ [s]
  bool multiplicative = false;    ///< split F = Fₑ Fᵥ in place of the convolution
  double rate_exponent = 1.0;     ///< m [-], multiplicative branches alone
  double reference_strain = 0.1;  ///< q₀ [-]
};

/// Material constants in the one form the kernels use.
///
/// The total stress is S = c_d S_d + c_v S_v + Σ Qᵢ with S_d, S_v of the
/// instantaneous moduli and c the long-term shares, c = 1 − Σ g.
struct ViscoelasticConstants {
  Moduli instantaneous;
  double long_term_deviatoric = 1.0;  ///< c_d [-]
  double long_term_volumetric = 1.0;  ///< c_v [-]
  std::vector<BranchConstants> branches;
  ElasticConstants elastic;  ///< the law, with the instantaneous moduli
  InelasticConstants inelastic;
  std::vector<RadialLayer> layers;
  bool mean_dilatation = false;  ///< cells of this material would lock without

  /// Whether energy can be lost or kept elsewhere than in the elastic law.
  bool dissipates() const {
    return !branches.empty() || inelastic.retardation_time > 0.0 || inelastic.remembers_strain;
  }
};

/// Converts user-level material numbers of either modulus basis.
///
///   instantaneous: μ₀, K₀ from (E, ν); shares g = ratio
///   long-term:     μ∞, K∞ from (E, ν); μ₀ = μ∞ (1 + Σ r), K₀ = K∞ (1 + Σ_all r),
///                  g_d = r μ∞/μ₀, g_v = r K∞/K₀ for branches that relax all
///
/// Limit:  both bases give the same constants for the same solid
///         -> test ViscoelasticConstantsTest.BasesAgree
/// Terms are scaled so that Σ μᵢ = μ₀; β that a hyperfoam's terms give must lead
/// to the Poisson ratio of the material within 0.002, and share what is left.
/// Errors: Error(bad_input) as check(material), see fem/interface/check_material.hpp.
ViscoelasticConstants viscoelastic_constants(const Material& material);

}  // namespace rebound::fem
