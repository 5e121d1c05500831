#include "fem/discretisation/layer_factors.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {

PointFactors layer_factors(const Discretisation& body, const std::vector<RadialLayer>& layers) {
  PointFactors factors;
  if (layers.empty()) return factors;
  const auto [low, high] =
      std::minmax_element(body.position.begin(), body.position.end(),
                          [](const auto& a, const auto& b) { return a[1] < b[1]; });
  const double centre = 0.5 * ((*low)[1] + (*high)[1]), radius = 0.5 * ((*high)[1] - (*low)[1]);
  for (const auto& cell : body.cells) {
    auto& at = factors.emplace_back();
    for (int q = 0; q < points_per_cell; ++q) {
      double height = -centre;
      for (int i = 0; i < nodes_per_cell; ++i)
        height += cell.shape[q][i] * body.position[cell.nodes[i]][1];
      const double from_centre = std::hypot(cell.radius[q], height) / radius;
      at[q] = 1.0;
      for (const RadialLayer& layer : layers)
        if (from_centre > layer.from) at[q] = layer.modulus_factor;
    }
  }
  return factors;
}

}  // namespace rebound::fem
