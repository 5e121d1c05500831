#pragma once

#include "fem/interface/elastic_models.hpp"
#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/elastic_model.hpp"
#include "fem/materials/elastic_model_headers.hpp"  // written by CMake from elastic_models.inc

namespace rebound::fem {

/// Calls `use` with the model made from what its shape takes.
template <class Model, ElasticShape shape, class Use>
inline auto use_elastic(const ElasticConstants& constants, const Use& use) {
  if constexpr (shape == ElasticShape::moduli)
    return use(Model{constants.moduli});
  else if constexpr (shape == ElasticShape::second_share)
    return use(Model{constants.moduli, constants.second_share});
  else
    return use(Model{constants.moduli, constants.terms});
}

#define REBOUND_ELASTIC_MODEL(Type, enumerator, name, shape, energy) \
  case ElasticModel::enumerator: return use_elastic<Type, ElasticShape::shape>(constants, use);
/// Calls `use` with the elastic law of `constants`: the one place where a model's
/// name becomes its type. In kernel files `use` must be a type of that file
/// alone (a lambda in an unnamed namespace), so that no copy of this is shared.
template <class Use>
inline auto with_elastic(const ElasticConstants& constants, const Use& use) {
  switch (constants.model) {
#include "fem/interface/elastic_models.inc"
  }
  __builtin_unreachable();
}
#undef REBOUND_ELASTIC_MODEL

}  // namespace rebound::fem
