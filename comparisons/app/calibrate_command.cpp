#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/app/calibrate_material.hpp"
#include "comparisons/app/calibration_output.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

std::string calibrate_help() {
  return "Keys of FILE (TOML) for a contact law:\n" + help_text<CalibrationFile>() +
         "\nKeys of FILE for the material of the FE tier:\n" +
         help_text<MaterialCalibrationFile>() +
         "\nThe calibrated law is printed as an impact file that `rebound lumped` runs; --out "
         "writes it to\ncalibrated.toml, beside calibration.json. With --out, a calibration that "
         "was "
         "stopped or killed goes on\nwhere it was when the same command is given again "
         "(checkpoint.json, removed at the end).\n\n" +
         exit_code_help();
}

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

ExitCode run_calibrate(const Session& session, const std::string& path) {
  const Document document = Document::load(path);
  if (asks_for_material(document)) return calibrate_material_file(session, path, document);
  CalibrationFile file;
  read_document(document, file);
  std::vector<std::string> labels;
  const std::vector<MeasuredImpact> shots = read_shots(document, file, labels);
  file.options.controls.checkpoint = checkpoint_of(session);
  const LawCalibration calibration = [&] {
    ProgressLine progress("calibration");
    try {
      return calibrate(file.request, shots, file.options, progress.control());
    } catch (const Error& error) {
      throw annotate(error, document, file.options.controls.checkpoint);
    }
  }();
  return write_calibration(
      session, document, path,
      {.head = {{"schema", 1}, {"law", calibration.model.law}, {"references", labels}},
       .fit = calibration.fit,
       .seed = file.options.controls.seed,
       .model_toml = impact_file_of(calibration, shots)});
}

}  // namespace

Action declare_calibrate(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command
      .add_option("FILE", *file,
                  "Calibration file: a law or a material, and what it is calibrated to")
      ->required();
  command.footer(calibrate_help);
  return [file](const Session& session) { return run_calibrate(session, *file); };
}

}  // namespace rebound
