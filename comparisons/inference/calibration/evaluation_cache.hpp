#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// A residual function that remembers its answers in a file, so that a
/// calibration that was killed goes on where it was: run again, it asks the
/// same questions in the same order and is answered from the file until it
/// reaches the point it had got to. The result is the same to the last bit.
///
/// The file is written atomically, at most every `interval`, and whenever an
/// evaluation throws on; kill -9 loses at most that interval.
///
/// Errors: Error(corrupt_store) for a file that is damaged; Error(bad_input)
///         for one that belongs to another calibration (other parameters,
///         bounds or controls, or other residuals at the start).
class EvaluationCache {
 public:
  /// `first` are the residuals at the start of the parameters.
  EvaluationCache(const CalibrationProblem& problem, const std::vector<double>& first,
                  std::chrono::milliseconds interval = std::chrono::seconds(2));

  std::vector<double> operator()(const std::vector<double>& x);
  /// Writes what is not written yet.
  void save();
  int from_file() const { return from_file_; }

 private:
  using Answer = std::optional<std::vector<double>>;  ///< empty: the model had none

  void load();

  ResidualFunction residuals_;
  std::filesystem::path file_;
  std::string digest_;
  std::chrono::milliseconds interval_;
  std::chrono::steady_clock::time_point saved_;
  std::map<std::vector<double>, Answer> answers_;
  bool unsaved_ = false;
  int from_file_ = 0;
};

}  // namespace rebound
