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

/// A curve through `value` at `place`, flat before and after.
template <std::size_t Count>
Bends<Count> bends_through(const std::array<double, Count>& place,
                           const std::array<double, Count>& value, double last_slope) {
  Bends<Count> bends{.act = true, .at_zero = value.front(), .place = place};
  double slope = 0.0;
  for (std::size_t k = 0; k < Count; ++k) {
    const double next =
        k + 1 < Count ? (value[k + 1] - value[k]) / (place[k + 1] - place[k]) : last_slope;
    bends.change[k] = next - slope;
    bends.steepest = std::max(bends.steepest, next);
    slope = next;
  }
  return bends;
}

Bends<StrainCurve::points> bends_of(const StrainCurve& curve) {
  if (curve.reach == 0.0) return {};
  std::array<double, StrainCurve::points> strain{};
  for (std::size_t k = 0; k < strain.size(); ++k)
    strain[k] = curve.reach * static_cast<double>(k) / static_cast<double>(strain.size() - 1);
  return bends_through(strain, curve.value, 0.0);
}

Bends<UnloadingCurve::points> bends_of(const UnloadingCurve& curve) {
  if (!curve.acts()) return {};
  std::array<double, UnloadingCurve::points> share{};
  for (std::size_t k = 0; k < share.size(); ++k) {
    const double left = 1.0 - static_cast<double>(k) / static_cast<double>(share.size());
    share[k] = 1.0 - left * left;
  }
  return bends_through(share, curve.value, -curve.value.back() / (1.0 - share.back()));
}

InelasticConstants inelastic_of(const Material& material, const ViscoelasticConstants& constants) {
  const StrainDependence& k = material.strain;
  const Moduli& m = constants.instantaneous;
  InelasticConstants inelastic{.factor_acts = k != StrainDependence{},
                               .remembers_strain = k.remembers(),
                               .factor = {.stiffening = k.stiffening,
                                          .softening = k.softening,
                                          .densification = k.densification,
                                          .mullins = k.mullins,
                                          .curve = bends_of(k.curve),
                                          .unloading = bends_of(k.unloading),
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
  constants.mean_dilatation = needs_mean_dilatation(material);
  return constants;
}

}  // namespace rebound::fem
