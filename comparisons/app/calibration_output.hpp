#pragma once

#include <filesystem>
#include <string>

#include "comparisons/app/session.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/document.hpp"

namespace rebound {

/// Where evaluations are kept while a calibration runs; makes the folder.
/// Empty without --out.
std::filesystem::path checkpoint_of(const Session& session);

/// What a user is told of an error in a calibration: the place in the file, or
/// after Ctrl-C that the same command goes on from the checkpoint.
Error annotate(const Error& error, const Document& document,
               const std::filesystem::path& checkpoint);

/// A calibration as it leaves the program, whichever tier was calibrated.
struct CalibrationOutput {
  Json head;  ///< what was calibrated to what; comes first
  CalibrationResult fit;
  std::uint64_t seed = 1;
  std::string model_toml;  ///< the calibrated model as an impact file
};

/// Prints it, and with --out stores calibration.json and calibrated.toml and
/// removes the checkpoint. Status: solver_failed where the search did not converge.
ExitCode write_calibration(const Session& session, const Document& document,
                           const std::string& path, const CalibrationOutput& output);

}  // namespace rebound
