#pragma once

#include <string>

#include "comparisons/evaluation/benchmark/benchmark.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/io/results/json.hpp"

/// Calibration and benchmark results as JSON and as text for a terminal.
namespace rebound {

/// A calibration as it leaves the program, whichever tier was calibrated.
struct CalibrationOutput {
  Json head;  ///< what was calibrated to what; comes first
  CalibrationResult fit;
  std::uint64_t seed = 1;
  std::string model_toml;  ///< the calibrated model as an impact file
};

Json to_json(const CalibrationOutput& output);
Json to_json(const CalibrationResult& result);
std::string to_text(const CalibrationResult& result);

Json to_json(const BenchmarkMatrix& matrix);
/// One block a quantity, laws down, references across, errors in per cent.
std::string to_text(const BenchmarkMatrix& matrix);

}  // namespace rebound
