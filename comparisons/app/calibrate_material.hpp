#pragma once

#include <filesystem>

#include "comparisons/app/calibration_text.hpp"
#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Is this calibration file for the material of the FE tier?
bool asks_for_material(const Document& document);

/// Fits the material of a calibration file to its references. Evaluations are kept in `checkpoint`
/// unless it is empty. The model is the impact of the first reference.
/// Errors: those of the file and its references; of the fit, with their place in the file.
CalibrationOutput calibrate_material_file(const Document& document,
                                          const std::filesystem::path& checkpoint,
                                          const RunControl& control);

}  // namespace rebound
