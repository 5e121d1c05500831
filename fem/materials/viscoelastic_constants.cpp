#include "fem/materials/viscoelastic_constants.hpp"

#include <algorithm>

#include "fem/interface/check_material.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"

namespace rebound::fem {
namespace {

StretchTerms terms_of(const Material& material, const Moduli& moduli) {
  StretchTerms terms;
  if (!has_terms(material.elastic)) return terms;
  double weights = 0.0;
  for (const auto& term : material.terms) weights += term.weight;
  for (const auto& term : material.terms) {
    terms.shear[terms.count] = moduli.shear * (term.weight / weights);
    terms.exponent[terms.count] = term.exponent;
    ++terms.count;
  }
  const std::vector<double> betas = instantaneous_betas(material);
  std::copy(betas.begin(), betas.end(), terms.beta);
  return terms;
}

InelasticConstants inelastic_of(const Material& material, const ViscoelasticConstants& constants) {
  const StrainDependence& k = material.strain;
  const Moduli& m = constants.instantaneous;
  InelasticConstants inelastic{.factor_acts = k != StrainDependence{},
                               .remembers_strain = k.mullins > 0.0,
                               .factor = {.stiffening = k.stiffening,
                                          .softening = k.softening,
                                          .densification = k.densification,
                                          .mullins = k.mullins,
                                          .youngs_modulus = youngs_modulus(m)},
                               .retardation_time = material.retardation_time};
  for (const auto& branch : constants.branches) {
    if (!branch.multiplicative) continue;
    inelastic.has_multiplicative = true;
    // A branch of the deviator takes nothing off the bulk modulus: the bound
    // of the law then stays whole.
    if (branch.volumetric_share > 0.0) inelastic.law_growth_share -= branch.deviatoric_share;
  }
  inelastic.acts =
      inelastic.factor_acts || inelastic.has_multiplicative || inelastic.retardation_time > 0.0;
  return inelastic;
}

}  // namespace

ViscoelasticConstants viscoelastic_constants(const Material& material) {
  check(material);
  const RelaxingShares sum = relaxing_shares(material);
  ViscoelasticConstants constants;
  const bool long_term = material.modulus == ModulusBasis::long_term;
  const double scale_deviatoric = long_term ? 1.0 + sum.deviatoric : 1.0;
  const double scale_volumetric = long_term ? 1.0 + sum.volumetric : 1.0;
  constants.instantaneous = instantaneous_moduli(material);
  for (const auto& branch : material.branches) {
    const bool all = branch.relaxes == Relaxes::all;
    constants.branches.push_back(
        {.deviatoric_share = branch.ratio / scale_deviatoric,
         .volumetric_share = all ? branch.ratio / scale_volumetric : 0.0,
         .relaxation_time = branch.relaxation_time,
         .multiplicative =
             material.relaxation == Relaxation::multiplicative || branch.rate_exponent != 1.0,
         .rate_exponent = branch.rate_exponent,
         .reference_strain = branch.reference_strain});
  }
  constants.long_term_deviatoric = 1.0 - sum.deviatoric / scale_deviatoric;
  constants.long_term_volumetric = 1.0 - sum.volumetric / scale_volumetric;
  constants.elastic = {.model = material.elastic,
                       .moduli = constants.instantaneous,
                       .second_share = material.second_share,
                       .terms = terms_of(material, constants.instantaneous)};
  constants.inelastic = inelastic_of(material, constants);
  constants.layers = material.layers;
  return constants;
}

}  // namespace rebound::fem
