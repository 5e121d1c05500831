#include "comparisons/io/toml/describe_material.hpp"

#include "fem/interface/elastic_models.hpp"

namespace rebound {

void describe(Visitor& visit, PronyBranch& branch) {
  visit.number<&PronyBranch::ratio>(
      branch, {.sentence = "With an instantaneous modulus the share of it that relaxes (shares "
                           "sum below 1); with a long-term modulus the branch over it."});
  visit.number<&PronyBranch::relaxation_time>(branch, {.sentence = "Time constant of the branch."});
  visit.choice({.name = "relaxes",
                .sentence = "All of the stress (Poisson ratio constant) or the deviator "
                            "alone (bulk modulus constant).",
                .presence = Presence::optional},
               branch.relaxes);
  visit.number<&PronyBranch::rate_exponent>(
      branch, {.sentence = "Flow strain grows as rate to this power; 1 when absent. Any other acts "
                           "by the multiplicative split; toward 0 the branch yields at "
                           "reference_strain and stays bent."});
  visit.number<&PronyBranch::reference_strain>(
      branch, {.sentence = "Elastic strain at which relaxation_time holds when rate_exponent is "
                           "not 1; 0.1 when absent."});
}

void describe(Visitor& visit, RadialLayer& layer) {
  visit.number<&RadialLayer::from>(
      layer, {.sentence = "Distance from the centre over the radius where the layer begins."});
  visit.number<&RadialLayer::modulus_factor>(
      layer, {.sentence = "All moduli of the layer over those of the material."});
}

namespace {

std::string energies() {
  std::string text = "Stored energy.";
  for (const ElasticModelCard& card : elastic_models())
    text += std::string(" ") + card.name + ": " + card.energy + ".";
  return text;
}

void describe_term(Visitor& visit, StretchTerm& term, ElasticModel elastic) {
  visit.number<&StretchTerm::weight>(
      term, {.sentence = "Share of the shear modulus, up to a factor common to all terms; "
                         "published moduli can stand here as plain numbers."});
  visit.number<&StretchTerm::exponent>(
      term, {.sentence = "Exponent alpha, not 0: 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha "
                         "- 3)."});
  if (shape_of(elastic) == ElasticShape::terms_with_beta)
    visit.number<&StretchTerm::beta>(
        term, {.sentence = "beta = nu/(1 - 2 nu) of this term; absent: of poisson_ratio. Given "
                           "ones must lead to poisson_ratio.",
               .presence = Presence::optional});
}

/// Keys that belong to one elastic law alone.
void describe_shape(Visitor& visit, Material& material) {
  const auto choose = [&](const std::string& name) { read_name(name, material.elastic); };
  visit.cases(all_names<ElasticModel>(), name_of(material.elastic), choose, [&](Visitor& inner) {
    if (shape_of(material.elastic) == ElasticShape::second_share)
      inner.number<&Material::second_share>(
          material, {.sentence = "C01/(C10 + C01); 0 leaves the first invariant alone.",
                     .presence = Presence::optional});
    if (!has_terms(material.elastic)) return;
    inner.visit_list(
        {.name = "term",
         .sentence = "One term of the energy; repeat for more, six at most.",
         .presence = Presence::required},
        {[&] { return material.terms.size(); }, [&](std::size_t n) { material.terms.resize(n); },
         [&](Visitor& one, std::size_t i) {
           StretchTerm example;
           describe_term(one, i < material.terms.size() ? material.terms[i] : example,
                         material.elastic);
         }});
  });
}

void describe_inelastic(Visitor& visit, Material& material) {
  visit.number<&Material::retardation_time>(
      material,
      {.sentence = "Kelvin-Voigt viscous stress: this time times the instantaneous moduli "
                   "times the rate of deformation; absent: none."});
  StrainDependence& strain = material.strain;
  visit.number<&StrainDependence::stiffening>(
      strain, {.sentence = "a of the factor 1 + a e on the elastic stress, e = sqrt(2 W/E) the "
                           "effective strain of a point; absent: 0."});
  visit.number<&StrainDependence::softening>(
      strain, {.sentence = "b of the factor 1 - b (1 - exp(-20 e)): a plateau; absent: 0."});
  visit.number<&StrainDependence::densification>(
      strain, {.sentence = "c of the factor 1 + c <e - 1/4>^2; absent: 0."});
  visit.number<&StrainDependence::mullins>(
      strain, {.sentence = "d of the factor 1 - d (1 - e/e_max) below the largest strain of a "
                           "point so far; absent: 0."});
}

}  // namespace

void describe(Visitor& visit, Material& material) {
  visit.choice({.name = "elastic", .sentence = energies()}, material.elastic);
  visit.number<&Material::youngs_modulus>(material,
                                          {.sentence = "Young's modulus at small strain."});
  visit.number<&Material::poisson_ratio>(
      material,
      {.sentence =
           "Poisson ratio of the same state; above 0.45 before or after relaxing, cells have "
           "a mean dilatation, against locking."});
  visit.choice({.name = "modulus",
                .sentence = "The state that modulus and Poisson ratio describe.",
                .presence = Presence::optional},
               material.modulus);
  visit.choice(
      {.name = "relaxation",
       .sentence = "How branches act: convolution of the second Piola-Kirchhoff stress, as common "
                   "codes do, not proved dissipative at large strain when all of the stress "
                   "relaxes; or a multiplicative split with an energy and a flow rule, which is.",
       .presence = Presence::optional},
      material.relaxation);
  describe_inelastic(visit, material);
  describe_shape(visit, material);
  visit.list({.name = "branch",
              .sentence = "One Prony branch; repeat for more.",
              .presence = Presence::optional},
             material.branches);
  visit.list({.name = "layer",
              .sentence = "A radial layer, from a distance outward; the outermost last.",
              .presence = Presence::optional},
             material.layers);
}

}  // namespace rebound
