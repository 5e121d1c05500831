#pragma once

#include <filesystem>
#include <string>

#include "comparisons/app/calibration_text.hpp"
#include "comparisons/app/session.hpp"
#include "comparisons/io/toml/document.hpp"

namespace rebound {

/// Where evaluations are kept while a calibration runs; makes the folder.
/// Empty without --out.
std::filesystem::path checkpoint_of(const Session& session);

/// What a user is told of an error in a calibration: after Ctrl-C that the same command goes on
/// from the checkpoint.
Error annotate(const Error& error, const std::filesystem::path& checkpoint);

/// Prints it, and with --out stores calibration.json and calibrated.toml and
/// removes the checkpoint. Status: solver_failed where the search did not converge.
ExitCode write_calibration(const Session& session, const Document& document,
                           const std::string& path, const CalibrationOutput& output);

}  // namespace rebound
