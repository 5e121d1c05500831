#pragma once

#include <string>
#include <vector>

#include "comparisons/config/visitor.hpp"

namespace rebound {

/// A file that asks for the numbers of an FE material.
struct MaterialCalibrationFile {
  std::string model;               ///< impact file: the ball and the material to start from
  std::vector<std::string> free;   ///< keys of material numbers
  std::vector<std::string> folders;
  double reach = 30.0;             ///< bounds: this many times the start either way
  int starts = 6;
  int seed = 1;
  double confidence = 0.95;
  double restitution_uncertainty = 0.01;   ///< where none is stated [-]
  double contact_time_uncertainty = 0.01;  ///< where none is stated, over the value [-]
};
void describe(Visitor& visit, MaterialCalibrationFile& file);

}  // namespace rebound
