#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/app/calibrate_law.hpp"
#include "comparisons/app/calibrate_material.hpp"
#include "comparisons/app/calibration_output.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"

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

ExitCode run_calibrate(const Session& session, const std::string& path) {
  const Document document = Document::load(path);
  const auto run = asks_for_material(document) ? calibrate_material_file : calibrate_law_file;
  const auto checkpoint = checkpoint_of(session);
  const CalibrationOutput output = [&] {
    ProgressLine progress("calibration");
    try {
      return run(document, checkpoint, progress.control());
    } catch (const Error& error) {
      throw annotate(error, checkpoint);
    }
  }();
  return write_calibration(session, document, path, output);
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
