#pragma once

#include <filesystem>

#include "comparisons/app/calibration_text.hpp"
#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Fits the law of a calibration file to its references. Evaluations are kept in `checkpoint`
/// unless it is empty. The model is the first reference's impact under the calibrated law.
/// Errors: those of the file and its references; of the fit, with their place in the file.
CalibrationOutput calibrate_law_file(const Document& document,
                                     const std::filesystem::path& checkpoint,
                                     const RunControl& control);

}  // namespace rebound
