#include "comparisons/app/calibrate_law.hpp"

#include <utility>

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

std::vector<MeasuredImpact> read_shots(const Document& document, const CalibrationFile& file,
                                       std::vector<std::string>& labels) {
  std::vector<MeasuredImpact> shots;
  for (const auto& reference : file.references)
    for (auto& found : file.options.observable == Observable::scalars
                           ? read_scalar_references(document.folder() / reference.folder)
                           : read_references(document.folder() / reference.folder)) {
      labels.push_back(found.label);
      shots.push_back(std::move(found));
    }
  return shots;
}

/// The first reference's impact under the calibrated law.
std::string impact_file_of(const LawCalibration& calibration,
                           const std::vector<MeasuredImpact>& shots) {
  return write_toml(LumpedProblem{.sphere = shots.front().sphere,
                                  .impact = shots.front().impact,
                                  .model = calibration.model,
                                  .controls = {}});
}

}  // namespace

CalibrationOutput calibrate_law_file(const Document& document,
                                     const std::filesystem::path& checkpoint,
                                     const RunControl& control) {
  CalibrationFile file;
  read_document(document, file);
  std::vector<std::string> labels;
  const std::vector<MeasuredImpact> shots = read_shots(document, file, labels);
  file.options.controls.checkpoint = checkpoint;
  LawCalibration calibration;
  document.locating([&] { calibration = calibrate(file.request, shots, file.options, control); });
  return {.head = {{"schema", 1}, {"law", calibration.model.law}, {"references", labels}},
          .fit = calibration.fit,
          .seed = file.options.controls.seed,
          .model_toml = impact_file_of(calibration, shots)};
}

}  // namespace rebound
