#include "fem/materials/viscoelastic_constants.hpp"

#include <cmath>
#include <string>

#include "fem/materials/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/out_of_range.hpp"

namespace rebound::fem {
namespace {

void require(bool fine, const char* key, double value, const char* allowed) {
  if (!fine) refuse_out_of_range(std::string("model.material.") + key, value, allowed);
}

bool positive(double value) { return value > 0 && std::isfinite(value); }
bool zero_or_positive(double value) { return value == 0 || positive(value); }

bool has_terms(const Material& material) {
  return material.elastic == ElasticModel::ogden || material.elastic == ElasticModel::hyperfoam;
}

void check_terms(const Material& material) {
  if (material.elastic == ElasticModel::mooney_rivlin)
    require(material.second_share >= 0 && material.second_share <= 1, "second_share",
            material.second_share, "[0, 1]");
  if (!has_terms(material)) return;
  const auto count = static_cast<double>(material.terms.size());
  require(count > 0 && count <= largest_term_count, "term", count, "1 to 6 terms");
  for (const auto& term : material.terms) {
    require(positive(term.weight), "term.weight", term.weight, "> 0");
    require(term.exponent != 0 && std::abs(term.exponent) <= 50, "term.exponent", term.exponent,
            "-50 to 50, not 0");
    if (material.elastic == ElasticModel::hyperfoam && term.beta)
      require(*term.beta > -1.0 / 3.0 && *term.beta <= 100, "term.beta", *term.beta, "(-1/3, 100]");
  }
}

/// Σ μᵢ βᵢ/μ that makes Σ 2μᵢ (1/3 + βᵢ) the bulk modulus.
double mean_beta(const Moduli& moduli) { return moduli.bulk / (2.0 * moduli.shear) - 1.0 / 3.0; }

/// `given` are the moduli that the user's Poisson ratio belongs to.
StretchTerms terms_of(const Material& material, const Moduli& moduli, const Moduli& given) {
  StretchTerms terms;
  if (!has_terms(material)) return terms;
  double weights = 0.0;
  for (const auto& term : material.terms) weights += term.weight;
  double mean = 0.0;  // Σ μᵢ βᵢ/μ
  for (const auto& term : material.terms) {
    terms.shear[terms.count] = moduli.shear * (term.weight / weights);
    terms.exponent[terms.count] = term.exponent;
    terms.beta[terms.count] = term.beta.value_or(mean_beta(given));
    mean += term.weight / weights * terms.beta[terms.count];
    ++terms.count;
  }
  if (material.elastic != ElasticModel::hyperfoam) return terms;
  const double found = mean / (1.0 + 2.0 * mean);
  if (!(std::abs(found - material.poisson_ratio) <= 0.002))
    throw Error(ExitCode::bad_input, "the terms of the hyperfoam lead to another Poisson ratio",
                {.key = "model.material.poisson_ratio",
                 .value = std::to_string(material.poisson_ratio),
                 .allowed = std::to_string(found)});
  for (int i = 0; i < terms.count; ++i) {
    terms.beta[i] += mean_beta(moduli) - mean;
    require(terms.beta[i] > -1.0 / 3.0, "term.beta", terms.beta[i],
            "above -1/3 before anything has relaxed");
  }
  return terms;
}

void check_inelastic(const Material& material) {
  require(zero_or_positive(material.retardation_time), "retardation_time",
          material.retardation_time, ">= 0 s");
  const StrainDependence& k = material.strain;
  require(zero_or_positive(k.stiffening), "strain_stiffening", k.stiffening, ">= 0");
  require(k.softening >= 0 && k.softening < 1, "strain_softening", k.softening, "[0, 1)");
  require(zero_or_positive(k.densification), "densification", k.densification, ">= 0");
  require(k.mullins >= 0 && k.mullins <= 1, "mullins", k.mullins, "[0, 1]");
  double inside = -1.0;
  for (const auto& layer : material.layers) {
    require(layer.from >= 0 && layer.from < 1 && layer.from > inside, "layer.from", layer.from,
            "[0, 1), each above the one before");
    require(positive(layer.modulus_factor), "layer.modulus_factor", layer.modulus_factor, "> 0");
    inside = layer.from;
  }
  for (const auto& branch : material.branches) {
    require(branch.rate_exponent > 0 && branch.rate_exponent <= 10, "branch.rate_exponent",
            branch.rate_exponent, "(0, 10]");
    require(positive(branch.reference_strain), "branch.reference_strain", branch.reference_strain,
            "> 0");
    if (k != StrainDependence{} && branch.relaxes == Relaxes::deviator)
      throw Error(ExitCode::bad_input,
                  "a factor on the elastic stress has an energy only where every branch relaxes all "
                  "of the stress",
                  {.key = "model.material.branch.relaxes", .value = "deviator", .allowed = "all"});
  }
}

void check(const Material& material) {
  require(positive(material.youngs_modulus), "youngs_modulus", material.youngs_modulus, "> 0 Pa");
  require(material.poisson_ratio > -1 && material.poisson_ratio <= largest_poisson_ratio,
          "poisson_ratio", material.poisson_ratio,
          "(-1, 0.45]; fully integrated cells lock above");
  check_terms(material);
  check_inelastic(material);
  double sum = 0.0;
  for (const auto& branch : material.branches) {
    require(positive(branch.ratio), "branch.ratio", branch.ratio, "> 0");
    require(positive(branch.relaxation_time), "branch.relaxation_time", branch.relaxation_time, "> 0 s");
    sum += branch.ratio;
  }
  if (material.modulus == ModulusBasis::instantaneous)
    require(sum < 1, "branch.ratio", sum, "sum of shares of the instantaneous modulus below 1");
}

InelasticConstants inelastic_of(const Material& material, const ViscoelasticConstants& constants) {
  const StrainDependence& k = material.strain;
  const Moduli& m = constants.instantaneous;
  InelasticConstants inelastic{
      .factor_acts = k != StrainDependence{},
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
  inelastic.acts = inelastic.factor_acts || inelastic.has_multiplicative ||
                   inelastic.retardation_time > 0.0;
  return inelastic;
}

}  // namespace

ViscoelasticConstants viscoelastic_constants(const Material& material) {
  check(material);
  const Moduli given = Moduli::from_youngs(material.youngs_modulus, material.poisson_ratio);
  double ratio_deviatoric = 0.0;
  double ratio_volumetric = 0.0;
  for (const auto& branch : material.branches) {
    ratio_deviatoric += branch.ratio;
    if (branch.relaxes == Relaxes::all) ratio_volumetric += branch.ratio;
  }

  ViscoelasticConstants constants;
  const bool long_term = material.modulus == ModulusBasis::long_term;
  const double scale_deviatoric = long_term ? 1.0 + ratio_deviatoric : 1.0;
  const double scale_volumetric = long_term ? 1.0 + ratio_volumetric : 1.0;
  constants.instantaneous = {given.shear * scale_deviatoric, given.bulk * scale_volumetric};
  for (const auto& branch : material.branches) {
    const bool all = branch.relaxes == Relaxes::all;
    constants.branches.push_back(
        {.deviatoric_share = branch.ratio / scale_deviatoric,
         .volumetric_share = all ? branch.ratio / scale_volumetric : 0.0,
         .relaxation_time = branch.relaxation_time,
         .multiplicative = material.relaxation == Relaxation::multiplicative ||
                           branch.rate_exponent != 1.0,
         .rate_exponent = branch.rate_exponent,
         .reference_strain = branch.reference_strain});
  }
  constants.long_term_deviatoric = 1.0 - ratio_deviatoric / scale_deviatoric;
  constants.long_term_volumetric = 1.0 - ratio_volumetric / scale_volumetric;
  constants.elastic = {.model = material.elastic,
                       .moduli = constants.instantaneous,
                       .second_share = material.second_share,
                       .terms = terms_of(material, constants.instantaneous, given)};
  constants.inelastic = inelastic_of(material, constants);
  constants.layers = material.layers;
  return constants;
}

}  // namespace rebound::fem
