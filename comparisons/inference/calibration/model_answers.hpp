#pragma once

#include <exception>
#include <functional>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"

namespace rebound {

/// Asks a model for rows within a search, in the scaled unknowns y = x / scale: counts, remembers
/// where there was no answer, and keeps errors that are none until Ceres has returned.
class ModelAnswers {
 public:
  /// Rows at x.
  using Model = std::function<std::vector<double>(const std::vector<double>& x)>;

  explicit ModelAnswers(const CalibrationProblem& problem);

  /// Rows of the model at y, so many; false where it has no answer.
  bool ask(const std::vector<double>& y, std::size_t rows, const Model& model,
           std::vector<double>& answer);
  /// ∂rows/∂y_j as the controls ask, one-sided in any case where a bound is nearer than a step or
  /// where the model has no answer on one side; false where it has none on either.
  bool difference(std::vector<double>& y, std::size_t j, const Model& model,
                  const std::vector<double>& centre, std::vector<double>& slope);

  /// Did the model have an answer on one side only, the last time the derivative by this parameter
  /// was taken? Where it is taken part by part: of any part since forget_edge().
  bool at_edge(std::size_t parameter) const { return edge_[parameter]; }
  void forget_edge(std::size_t parameter) { edge_[parameter] = false; }
  bool met_no_answer() const { return met_no_answer_; }
  int count() const { return count_; }
  /// An error other than "no answer here", to be thrown once Ceres has returned.
  std::exception_ptr failure() const { return failure_; }

 private:
  const CalibrationProblem& problem_;
  int count_ = 0;
  std::vector<bool> edge_;
  bool met_no_answer_ = false;
  std::exception_ptr failure_;
};

}  // namespace rebound
