#pragma once

#include <array>
#include <iterator>
#include <span>

#include "fem/interface/material.hpp"
#include "lumped/problem/names.hpp"

/// The elastic models of elastic_models.inc. Apart from material.hpp, so that a model
/// more is compiled again only where models are told apart.
namespace rebound {

#define REBOUND_ELASTIC_MODEL(Type, enumerator, name, shape, energy) enumerator,
enum class ElasticModel : int {
#include "fem/interface/elastic_models.inc"
};
#undef REBOUND_ELASTIC_MODEL

/// What a model is made from beside its moduli.
enum class ElasticShape {
  moduli,          ///< nothing
  second_share,    ///< Material::second_share
  terms,           ///< Material::terms: weights and exponents
  terms_with_beta  ///< the same with a β each, which sets the bulk modulus
};

struct ElasticModelCard {
  ElasticModel model;
  const char* name;  ///< in files
  ElasticShape shape;
  const char* energy;  ///< stored, in one line
};

#define REBOUND_ELASTIC_MODEL(Type, enumerator, name, shape, energy) \
  {ElasticModel::enumerator, name, ElasticShape::shape, energy},
inline constexpr ElasticModelCard elastic_model_cards[] = {
#include "fem/interface/elastic_models.inc"
};
#undef REBOUND_ELASTIC_MODEL

/// In the order of the list, which is that of the enumerators.
constexpr std::span<const ElasticModelCard> elastic_models() {
  return elastic_model_cards;
}

constexpr auto names_of(ElasticModel) {
  std::array<Named<ElasticModel>, std::size(elastic_model_cards)> names{};
  for (std::size_t i = 0; i < names.size(); ++i)
    names[i] = {elastic_model_cards[i].name, elastic_model_cards[i].model};
  return names;
}

constexpr ElasticShape shape_of(ElasticModel model) {
  return elastic_model_cards[static_cast<int>(model)].shape;
}

constexpr bool has_terms(ElasticModel model) {
  return shape_of(model) == ElasticShape::terms || shape_of(model) == ElasticShape::terms_with_beta;
}

}  // namespace rebound
