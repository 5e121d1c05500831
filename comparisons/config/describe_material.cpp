#include "comparisons/config/describe_material.hpp"

#include "comparisons/config/optional_number.hpp"

namespace rebound {

void describe(Visitor& visit, PronyBranch& branch) {
  visit.number({.name = "ratio",
                .sentence = "With an instantaneous modulus the share of it that relaxes (shares "
                            "sum below 1); with a long-term modulus the branch over it.",
                .range = at_least(0.0)},
               branch.ratio);
  visit.number({.name = "relaxation_time",
                .sentence = "Time constant of the branch.",
                .unit = "ms",
                .range = above(0.0)},
               branch.relaxation_time);
  visit.choice<Relaxes>({.name = "relaxes",
                         .sentence = "All of the stress (Poisson ratio constant) or the deviator "
                                     "alone (bulk modulus constant).",
                         .presence = Presence::optional},
                        {{"all", Relaxes::all}, {"deviator", Relaxes::deviator}}, branch.relaxes);
  const PronyBranch plain;
  number_unless(visit, plain.rate_exponent,
                {.name = "rate_exponent",
                 .sentence = "Flow strain grows as rate to this power; 1 when absent. Any other acts "
                             "by the multiplicative split; toward 0 the branch yields at "
                             "reference_strain and stays bent.",
                 .range = above_up_to(0.0, 10.0)},
                branch.rate_exponent);
  number_unless(visit, plain.reference_strain,
                {.name = "reference_strain",
                 .sentence = "Elastic strain at which relaxation_time holds when rate_exponent is "
                             "not 1; 0.1 when absent.",
                 .range = above(0.0)},
                branch.reference_strain);
}

void describe(Visitor& visit, RadialLayer& layer) {
  visit.number({.name = "from",
                .sentence = "Distance from the centre over the radius where the layer begins.",
                .range = {.lowest = 0.0, .highest = 1.0, .highest_allowed = false}},
               layer.from);
  visit.number({.name = "modulus_factor",
                .sentence = "All moduli of the layer over those of the material.",
                .range = above(0.0)},
               layer.modulus_factor);
}

namespace {

const std::vector<std::pair<std::string, ElasticModel>> elastic_names = {
    {"neo-hookean", ElasticModel::neo_hookean},
    {"neo-hookean-isochoric", ElasticModel::neo_hookean_isochoric},
    {"mooney-rivlin", ElasticModel::mooney_rivlin},
    {"ogden", ElasticModel::ogden},
    {"hyperfoam", ElasticModel::hyperfoam}};

void describe_term(Visitor& visit, StretchTerm& term, ElasticModel elastic) {
  visit.number({.name = "weight",
                .sentence = "Share of the shear modulus, up to a factor common to all terms; "
                            "published moduli can stand here as plain numbers.",
                .range = above(0.0)},
               term.weight);
  visit.number({.name = "exponent",
                .sentence = "Exponent alpha, not 0: 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha "
                            "- 3).",
                .range = from_to(-50.0, 50.0)},
               term.exponent);
  if (elastic == ElasticModel::hyperfoam)
    visit.number({.name = "beta",
                  .sentence = "beta = nu/(1 - 2 nu) of this term; absent: of poisson_ratio. Given "
                              "ones must lead to poisson_ratio.",
                  .presence = Presence::optional,
                  .range = {.lowest = -1.0 / 3.0, .highest = 100.0, .lowest_allowed = false}},
                 term.beta);
}

/// Keys that belong to one elastic law alone.
void describe_shape(Visitor& visit, Material& material) {
  std::vector<std::string> names;
  std::string chosen;
  for (const auto& [name, model] : elastic_names) {
    names.push_back(name);
    if (model == material.elastic) chosen = name;
  }
  const auto choose = [&](const std::string& name) {
    for (const auto& [known, model] : elastic_names)
      if (known == name) material.elastic = model;
  };
  visit.cases(names, chosen, choose, [&](Visitor& inner) {
    if (material.elastic == ElasticModel::mooney_rivlin)
      inner.number({.name = "second_share",
                    .sentence = "C01/(C10 + C01); 0 leaves the first invariant alone.",
                    .presence = Presence::optional,
                    .range = from_to(0.0, 1.0)},
                   material.second_share);
    if (material.elastic != ElasticModel::ogden && material.elastic != ElasticModel::hyperfoam)
      return;
    inner.visit_list({.name = "term",
                      .sentence = "One term of the energy; repeat for more, six at most.",
                      .presence = Presence::required},
                     {[&] { return material.terms.size(); },
                      [&](std::size_t n) { material.terms.resize(n); },
                      [&](Visitor& one, std::size_t i) {
                        StretchTerm example;
                        describe_term(one, i < material.terms.size() ? material.terms[i] : example,
                                      material.elastic);
                      }});
  });
}

void describe_inelastic(Visitor& visit, Material& material) {
  number_unless(visit, 0.0,
                {.name = "retardation_time",
                 .sentence = "Kelvin-Voigt viscous stress: this time times the instantaneous moduli "
                             "times the rate of deformation; absent: none.",
                 .unit = "us",
                 .range = at_least(0.0)},
                material.retardation_time);
  StrainDependence& strain = material.strain;
  number_unless(visit, 0.0,
                {.name = "strain_stiffening",
                 .sentence = "a of the factor 1 + a e on the elastic stress, e = sqrt(2 W/E) the "
                             "effective strain of a point; absent: 0.",
                 .range = at_least(0.0)},
                strain.stiffening);
  number_unless(visit, 0.0,
                {.name = "strain_softening",
                 .sentence = "b of the factor 1 - b (1 - exp(-20 e)): a plateau; absent: 0.",
                 .range = {.lowest = 0.0, .highest = 1.0, .highest_allowed = false}},
                strain.softening);
  number_unless(visit, 0.0,
                {.name = "densification",
                 .sentence = "c of the factor 1 + c <e - 1/4>^2; absent: 0.",
                 .range = at_least(0.0)},
                strain.densification);
  number_unless(visit, 0.0,
                {.name = "mullins",
                 .sentence = "d of the factor 1 - d (1 - e/e_max) below the largest strain of a "
                             "point so far; absent: 0.",
                 .range = from_to(0.0, 1.0)},
                strain.mullins);
}

}  // namespace

void describe(Visitor& visit, Material& material) {
  visit.choice<ElasticModel>(
      {.name = "elastic",
       .sentence = "Stored energy: mu/2 (I1 - 3 - 2 ln J) + lambda/2 (ln J)^2; or "
                   "mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2; or by its two invariants "
                   "(mooney-rivlin) or principal stretches (ogden, hyperfoam: give terms)."},
      elastic_names, material.elastic);
  visit.number({.name = "youngs_modulus",
                .sentence = "Young's modulus at small strain.",
                .unit = "MPa",
                .range = above(0.0)},
               material.youngs_modulus);
  visit.number({.name = "poisson_ratio",
                .sentence = "Poisson ratio of the same state; above 0.45 refused by the FE tier, "
                            "whose elements lock.",
                .range = between(-1.0, 0.5)},
               material.poisson_ratio);
  visit.choice<ModulusBasis>(
      {.name = "modulus",
       .sentence = "The state that modulus and Poisson ratio describe.",
       .presence = Presence::optional},
      {{"instantaneous", ModulusBasis::instantaneous}, {"long-term", ModulusBasis::long_term}},
      material.modulus);
  visit.choice<Relaxation>(
      {.name = "relaxation",
       .sentence = "How branches act: convolution of the second Piola-Kirchhoff stress, as common "
                   "codes do, not proved dissipative at large strain when all of the stress "
                   "relaxes; or a multiplicative split with an energy and a flow rule, which is.",
       .presence = Presence::optional},
      {{"convolution", Relaxation::convolution}, {"multiplicative", Relaxation::multiplicative}},
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
