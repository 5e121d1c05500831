#include "comparisons/app/calibrate_law.hpp"

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

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
  const std::vector<MeasuredImpact> shots = references_of(document, file);
  std::vector<std::string> labels;
  labels.reserve(shots.size());
  for (const MeasuredImpact& shot : shots) labels.push_back(shot.label);
  file.options.controls.checkpoint = checkpoint;
  LawCalibration calibration;
  document.locating([&] { calibration = calibrate(file.request, shots, file.options, control); });
  return {.head = {{"schema", 1}, {"law", calibration.model.law}, {"references", labels}},
          .fit = calibration.fit,
          .seed = file.options.controls.seed,
          .model_toml = impact_file_of(calibration, shots)};
}

}  // namespace rebound
