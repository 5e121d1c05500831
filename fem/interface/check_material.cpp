#include "fem/interface/check_material.hpp"

#include <algorithm>
#include <cmath>

#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Terms that round their own numbers lead to ν within this.
constexpr double poisson_tolerance = 0.002;

[[noreturn]] void refuse(const std::string& message, ErrorLocation location) {
  throw Error(ExitCode::bad_input, message, std::move(location));
}

KeyPath item(const char* list, std::size_t i, const KeyPath& at) {
  return {list, static_cast<int>(i), &at};
}

template <class Record>
void check_each(const std::vector<Record>& records, const char* list, const KeyPath& at) {
  for (std::size_t i = 0; i < records.size(); ++i) require_limits(records[i], item(list, i, at));
}

void check_shares(const Material& material, const KeyPath& at) {
  if (material.modulus != ModulusBasis::instantaneous) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < material.branches.size(); ++i) {
    sum += material.branches[i].ratio;
    if (!(sum < 1.0))
      refuse("the shares of the instantaneous modulus sum to " + number_text(sum) +
                 ", which leaves no long-term modulus",
             {.key = item("branch", i, at).of("ratio"),
              .value = number_text(material.branches[i].ratio),
              .allowed = "shares that sum below 1"});
  }
}

/// ν of both ends of relaxation. Between them it is no higher: K/μ is largest once every
/// deviator has relaxed.
void check_poisson_ratios(const Material& material, const KeyPath& at) {
  const Range& range = limit_of<&Material::poisson_ratio>.range;
  const auto check_state = [&](const char* state, const fem::Moduli& moduli) {
    const double found = fem::poisson_ratio(moduli);
    if (found <= range.highest + 1e-9) return;
    refuse(std::string("the ") + state + " Poisson ratio is " +
               number_text(std::round(found * 1e4) / 1e4) +
               ": branches that relax the deviator alone raise it as they relax",
           {.key = at.of("poisson_ratio"),
            .value = number_text(material.poisson_ratio),
            .allowed = "at most " + number_text(range.highest) +
                       " before and after relaxing; relaxes = \"all\" keeps it"});
  };
  check_state("instantaneous", fem::instantaneous_moduli(material));
  check_state("long-term", fem::long_term_moduli(material));
}

/// Each β has a share of the bulk modulus: above −1/3 in every state.
void check_betas(const Material& material, const KeyPath& at) {
  double weights = 0.0, betas = 0.0;
  std::size_t given = 0;
  for (const StretchTerm& term : material.terms) {
    weights += term.weight;
    betas += term.weight * term.beta.value_or(0.0);
    if (term.beta) ++given;
  }
  if (given != 0 && given < material.terms.size())
    refuse("beta stands in some terms only",
           {.key = item("term", 0, at).text(), .allowed = "beta in every term or in none"});
  if (given != 0) {
    const double mean = betas / weights, found = mean / (1.0 + 2.0 * mean);
    if (!(std::abs(found - material.poisson_ratio) <= poisson_tolerance))
      refuse("the betas of the terms lead to another Poisson ratio",
             {.key = at.of("poisson_ratio"),
              .value = number_text(material.poisson_ratio),
              .allowed = number_text(std::round(found * 1e4) / 1e4) + ", within 0.002"});
  }
  const std::vector<double> instantaneous = instantaneous_betas(material);
  for (std::size_t i = 0; i < instantaneous.size(); ++i)
    if (!(instantaneous[i] > limit_of<&StretchTerm::beta>.range.lowest))
      refuse("this term has no positive bulk modulus before anything has relaxed",
             {.key = item("term", i, at).of("beta"),
              .value = number_text(instantaneous[i]),
              .allowed = "above -1/3 before anything has relaxed"});
}

void check_terms(const Material& material, const KeyPath& at) {
  if (!has_terms(material.elastic)) return;
  const auto count = material.terms.size();
  if (count == 0 || count > most_stretch_terms)
    refuse("this law has " + std::to_string(count) + " terms",
           {.key = at.of("term"),
            .value = std::to_string(count),
            .allowed = "1 to " + std::to_string(most_stretch_terms) + " terms"});
  for (std::size_t i = 0; i < count; ++i)
    if (material.terms[i].exponent == 0.0)
      refuse("an exponent of 0 has no energy",
             {.key = item("term", i, at).of("exponent"),
              .value = "0",
              .allowed = allowed_text(limit_of<&StretchTerm::exponent>.range, "") + ", not 0"});
  if (shape_of(material.elastic) == ElasticShape::terms_with_beta) check_betas(material, at);
}

/// A factor on the stress has an energy only where both moduli relax alike.
void check_strain_factors(const Material& material, const KeyPath& at) {
  if (material.strain == StrainDependence{}) return;
  for (const double value : material.strain.curve.value)
    if (!(value >= -0.9))
      refuse("a factor that strain puts on the stress stays above a tenth",
             {.key = at.of("strain_curve"), .value = number_text(value), .allowed = ">= -0.9"});
  for (const double value : material.strain.unloading.value)
    if (!(value >= -1.0))
      refuse("unloading does not turn the stress around",
             {.key = at.of("unloading_curve"), .value = number_text(value), .allowed = ">= -1"});
  for (std::size_t i = 0; i < material.branches.size(); ++i)
    if (material.branches[i].relaxes == Relaxes::deviator)
      refuse(
          "factors of strain on the elastic stress have an energy only where every branch "
          "relaxes all of the stress",
          {.key = item("branch", i, at).of("relaxes"),
           .value = name_of(Relaxes::deviator),
           .allowed = name_of(Relaxes::all)});
}

void check_layers(const Material& material, const KeyPath& at) {
  for (std::size_t i = 1; i < material.layers.size(); ++i)
    if (!(material.layers[i].from > material.layers[i - 1].from))
      refuse("layers stand from the inside outward",
             {.key = item("layer", i, at).of("from"),
              .value = number_text(material.layers[i].from),
              .allowed = "above " + number_text(material.layers[i - 1].from)});
}

}  // namespace

void check(const Material& material, const KeyPath& at) {
  require_limits(material, at);
  require_limits(material.strain, at);
  check_each(material.branches, "branch", at);
  check_each(material.layers, "layer", at);
  check_each(material.terms, "term", at);
  check_shares(material, at);
  check_poisson_ratios(material, at);
  check_terms(material, at);
  check_strain_factors(material, at);
  check_layers(material, at);
}

bool convolution_alone(const Material& material) {
  const auto by_split = [&](const PronyBranch& branch) {
    return material.relaxation == Relaxation::multiplicative || branch.rate_exponent != 1.0;
  };
  return material.strain == StrainDependence{} && material.retardation_time == 0.0 &&
         material.layers.empty() &&
         std::none_of(material.branches.begin(), material.branches.end(), by_split);
}

void check_convolution_alone(const Material& material, const std::string& key) {
  if (!convolution_alone(material))
    refuse(
        "the implicit scheme has elastic laws and branches by convolution alone: no "
        "multiplicative branches, viscous stress, factors of strain or layers",
        {.key = key});
}

std::vector<double> instantaneous_betas(const Material& material) {
  std::vector<double> betas;
  if (shape_of(material.elastic) != ElasticShape::terms_with_beta) return betas;
  double weights = 0.0;
  for (const StretchTerm& term : material.terms) weights += term.weight;
  const double given = fem::mean_beta(fem::given_moduli(material));
  double mean = 0.0;  // Σ μᵢ βᵢ/μ
  for (const StretchTerm& term : material.terms) {
    betas.push_back(term.beta.value_or(given));
    mean += term.weight / weights * betas.back();
  }
  for (double& beta : betas) beta += fem::mean_beta(fem::instantaneous_moduli(material)) - mean;
  return betas;
}

}  // namespace rebound
