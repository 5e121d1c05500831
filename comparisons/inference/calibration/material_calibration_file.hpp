#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/material_calibration.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "lumped/problem/names.hpp"

namespace rebound {

/// What of an impact is fitted: restitution and contact time, or F(t).
enum class MaterialObservable { scalars, force_time };
constexpr auto names_of(MaterialObservable) {
  return names_list<MaterialObservable>(
      {{"scalars", MaterialObservable::scalars}, {"force-time", MaterialObservable::force_time}});
}

/// A file that asks for the numbers of an FE material.
struct MaterialCalibrationFile {
  std::string model;              ///< impact file: the ball and the material to start from
  std::vector<std::string> free;  ///< keys of material numbers
  std::vector<std::string> folders;
  MaterialObservable observable = MaterialObservable::scalars;
  double force_uncertainty = 0.01;  ///< of a trace that states none, over its peak [-]
  double reach = 30.0;              ///< bounds: this many times the start either way
  CalibrationControls controls{.starts = 6};
  double restitution_uncertainty = 0.01;   ///< where none is stated [-]
  double contact_time_uncertainty = 0.01;  ///< where none is stated, over the value [-]
};
void describe(Visitor& visit, MaterialCalibrationFile& file);

/// What such a file names, read: the FE model that the search starts from, and the impacts.
struct MaterialCalibrationInput {
  FemProblem start;
  std::vector<MeasuredImpact> measured;
};

/// All impacts of all folders; they must be of one ball, that of the model.
/// Errors: Error(bad_input) with the place in `document`, and those of reading.
MaterialCalibrationInput read_input(const Document& document, const MaterialCalibrationFile& file);

/// A calibration on the mesh of its slowest impact, and that mesh's size.
struct MeshedCalibration {
  MaterialCalibration found;
  std::size_t cells = 0;
};

/// Errors: those of calibrate_material, of the mesh, and of unknown names of free numbers.
MeshedCalibration calibrate_material(const MaterialCalibrationFile& file,
                                     const MaterialCalibrationInput& input,
                                     const RunControl& control);

}  // namespace rebound
