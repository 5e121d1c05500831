#pragma once

#include <array>
#include <string>
#include <vector>

#include "comparisons/report/figure.hpp"

namespace rebound::report {

/// Vertex positions at one instant, in the animation's units.
struct AnimationFrame {
  double time = 0.0;
  std::vector<double> radius;  ///< >= 0; the axis is radius 0
  std::vector<double> height;  ///< the plate is height 0
};

/// The half-section of a body of revolution that moves: its cells' outlines at a few
/// instants, mirrored at the axis, above the plate.
struct Animation {
  std::string title;
  std::string caption;
  Origin origin = Origin::predicted;
  std::string length_unit;
  std::string time_unit;
  std::vector<std::array<int, 4>> cells;  ///< vertex numbers around each cell
  std::vector<AnimationFrame> frames;     ///< in order of time, each with all vertices
};

}  // namespace rebound::report
