#include "comparisons/evaluation/export/solid_card.hpp"

#include "fem/interface/check_material.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"

namespace rebound {

double SolidCard::relaxing_deviator() const {
  double sum = 0.0;
  for (const RelaxingShare& branch : branches) sum += branch.deviator;
  return sum;
}

double SolidCard::relaxing_volume() const {
  double sum = 0.0;
  for (const RelaxingShare& branch : branches) sum += branch.volume;
  return sum;
}

SolidCard solid_card(const Material& material) {
  check(material);
  SolidCard card{.elastic = material.elastic,
                 .instantaneous = fem::instantaneous_moduli(material),
                 .long_term = fem::long_term_moduli(material)};
  const fem::Moduli given = fem::given_moduli(material);
  for (const PronyBranch& branch : material.branches)
    card.branches.push_back({.deviator = branch.ratio * given.shear / card.instantaneous.shear,
                             .volume = branch.relaxes == Relaxes::all
                                           ? branch.ratio * given.bulk / card.instantaneous.bulk
                                           : 0.0,
                             .relaxation_time = branch.relaxation_time});
  card.c01 = 0.5 * material.second_share * card.instantaneous.shear;
  card.c10 = 0.5 * card.instantaneous.shear - card.c01;
  card.d1 = 2.0 / card.instantaneous.bulk;
  if (!has_terms(material.elastic)) return card;
  double weights = 0.0;
  for (const StretchTerm& term : material.terms) weights += term.weight;
  const std::vector<double> betas = instantaneous_betas(material);
  for (std::size_t i = 0; i < material.terms.size(); ++i)
    card.terms.push_back({.shear = card.instantaneous.shear * material.terms[i].weight / weights,
                          .exponent = material.terms[i].exponent,
                          .beta = betas.empty() ? 0.0 : betas[i]});
  return card;
}

}  // namespace rebound
