#include "fem/contact/adhesive_layer.hpp"

#include <algorithm>

namespace rebound::fem {

AdhesiveLayer::AdhesiveLayer(const Discretisation& body, const AdhesiveTraction& traction)
    : traction_(traction), area_(body.contact_area) {}

double AdhesiveLayer::pull(std::size_t i, double gap) const {
  const double fade = 1.0 - std::max(gap, 0.0) / traction_.range;
  return fade > 0.0 ? area_[i] * 2.0 * traction_.work / traction_.range * fade : 0.0;
}

double AdhesiveLayer::potential(std::size_t i, double gap) const {
  const double fade = 1.0 - std::max(gap, 0.0) / traction_.range;
  return fade > 0.0 ? -area_[i] * traction_.work * fade * fade : 0.0;
}

}  // namespace rebound::fem
