#pragma once

#include <array>
#include <string>
#include <vector>

#include "comparisons/io/report/figure.hpp"

namespace rebound::report {

/// Vertex positions at one instant, in the animation's units.
struct AnimationFrame {
  double time = 0.0;
  std::vector<double> radius;  ///< >= 0; the axis is radius 0
  std::vector<double> height;  ///< the plate is height 0
};

/// A quantity of every cell, coloured over one range in all frames.
struct AnimationField {
  std::string name;   ///< e.g. "von Mises stress"
  std::string unit;   ///< "1" is dimensionless
  double low = 0.0;   ///< the first colour
  double high = 1.0;  ///< the last; what lies outside has the colour of its end
  std::vector<std::vector<float>> values;  ///< per frame, per cell
};

/// What the plate presses with, drawn under it as a curve over the radius.
struct AnimationContact {
  std::vector<int> vertices;  ///< from the axis outward; empty: nothing is drawn
  std::string unit;
  std::vector<std::vector<double>> pressure;  ///< per frame, per vertex
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
  std::vector<AnimationField> fields;     ///< a reader chooses one; may be empty
  AnimationContact contact;
};

}  // namespace rebound::report
