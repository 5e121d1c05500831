#pragma once

#include "fem/discretisation/discretisation.hpp"

namespace rebound::fem {

/// Factor of the moduli at each point of a body with radial layers: that of the
/// last layer that begins inside the point's distance from the centre, which
/// lies halfway up the body; R is half its height. Empty without layers.
///
/// Caution: a layer's edge is as sharp as the cells are small; a cell that it
///          cuts has both moduli at its points.
PointFactors layer_factors(const Discretisation& body, const std::vector<RadialLayer>& layers);

}  // namespace rebound::fem
