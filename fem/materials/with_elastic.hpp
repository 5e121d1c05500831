#pragma once

#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/elastic_model.hpp"
#include "fem/materials/hyperfoam.hpp"
#include "fem/materials/mooney_rivlin.hpp"
#include "fem/materials/neo_hookean.hpp"
#include "fem/materials/neo_hookean_isochoric.hpp"
#include "fem/materials/ogden.hpp"

namespace rebound::fem {

/// Calls `use` with the elastic law of `constants`: the one place where a model's
/// name becomes its type. In kernel files `use` must be a type of that file
/// alone (a lambda in an unnamed namespace), so that no copy of this is shared.
template <class Use>
inline auto with_elastic(const ElasticConstants& constants, const Use& use) {
  switch (constants.model) {
    case ElasticModel::neo_hookean: return use(NeoHookean{constants.moduli});
    case ElasticModel::neo_hookean_isochoric: return use(NeoHookeanIsochoric{constants.moduli});
    case ElasticModel::mooney_rivlin:
      return use(MooneyRivlin{constants.moduli, constants.second_share});
    case ElasticModel::ogden: return use(Ogden{constants.moduli, constants.terms});
    case ElasticModel::hyperfoam: return use(Hyperfoam{constants.moduli, constants.terms});
  }
  __builtin_unreachable();
}

}  // namespace rebound::fem
