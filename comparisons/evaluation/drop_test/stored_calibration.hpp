#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "comparisons/evaluation/drop_test/drop_test.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// A calibration.json as `rebound calibrate --out` writes it.
struct StoredCalibration {
  std::variant<LumpedProblem, FemProblem> problem;  ///< of the tier that was calibrated
  /// Absent where a parameter was not identified, or where parameters were
  /// fitted speed by speed; `why_not` then says so.
  std::optional<ParameterUncertainty> uncertainty;
  std::string why_not;
};

/// Errors: Error(input_output_failed) for a file that cannot be read;
///         Error(corrupt_store) for one that is no whole calibration.
StoredCalibration read_stored_calibration(const std::filesystem::path& file);

}  // namespace rebound
