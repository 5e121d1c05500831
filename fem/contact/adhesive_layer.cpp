#include "fem/contact/adhesive_layer.hpp"

#include <algorithm>

namespace rebound::fem {

AdhesiveLayer::AdhesiveLayer(const Discretisation& body, const AdhesiveTraction& traction)
    : traction_(traction), area_(body.contact_area) {}

double AdhesiveLayer::fade(double gap) const {
  return std::max(0.0, 1.0 - std::max(gap, 0.0) / traction_.range);
}

double AdhesiveLayer::pull(std::size_t i, double gap) const {
  return area_[i] * 2.0 * traction_.work / traction_.range * fade(gap);
}

double AdhesiveLayer::potential(std::size_t i, double gap) const {
  const double left = fade(gap);
  return -area_[i] * traction_.work * left * left;
}

}  // namespace rebound::fem
