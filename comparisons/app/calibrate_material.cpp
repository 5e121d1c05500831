#include "comparisons/app/calibrate_material.hpp"

#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {

bool asks_for_material(const Document& document) {
  return document.root()["tier"].value_or(std::string()) == "fem";
}

CalibrationOutput calibrate_material_file(const Document& document,
                                          const std::filesystem::path& checkpoint,
                                          const RunControl& control) {
  MaterialCalibrationFile file;
  read_document(document, file);
  const MaterialCalibrationInput input = read_input(document, file);
  file.controls.checkpoint = checkpoint;
  auto [found, cells] = [&] {
    try {
      return calibrate_material(file, input, control);
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  std::vector<std::string> labels;
  for (const MeasuredImpact& one : input.measured) {
    labels.push_back(one.label);
    found.fit.warnings.insert(found.fit.warnings.end(), one.assumed.begin(), one.assumed.end());
  }
  FemProblem problem = input.start;
  problem.material = found.material;
  problem.impact.speed = input.measured.front().impact.speed;
  return {.head = {{"schema", 1}, {"tier", "fem"}, {"cells", cells}, {"references", labels}},
          .fit = found.fit,
          .seed = file.controls.seed,
          .model_toml = write_toml(problem)};
}

}  // namespace rebound
