#pragma once

#include <ceres/cost_function.h>

#include <exception>
#include <vector>

#include "comparisons/inference/calibration/model_answers.hpp"

namespace rebound {

/// Residuals and Jacobian at one point of a search, in scaled unknowns.
struct LinearModel {
  std::vector<double> y;          ///< [n]
  std::vector<double> residuals;  ///< [m]
  std::vector<double> slopes;     ///< ∂r_i/∂y_j, [m][n]; empty: not taken here
};

/// What a search sees of a calibration: residuals and Jacobian, in the scaled unknowns
/// y = x / scale.
///
/// The Jacobian is the model's own where it has one; then residuals come with it and are
/// kept, since a point that is accepted is asked for both. Otherwise differences as the controls
/// ask, one-sided in any case where a bound is nearer than a step or where
/// the model has no answer on one side. Ceres' own numeric derivatives step
/// relative to the value, which fails at zero and does not respect bounds.
///
/// Where runs are dear, a point is asked for its residuals first, since one that is refused needs
/// no more.
class CalibrationCost final : public ceres::CostFunction {
 public:
  CalibrationCost(const CalibrationProblem& problem, int residuals);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

  bool at_edge(std::size_t parameter) const { return answers_.at_edge(parameter); }
  /// Takes one difference a parameter at y, to see where the model has no answer: needed
  /// where the Jacobian was the model's own and the search met points without answer.
  void look_for_edges(const std::vector<double>& y) const;
  bool met_no_answer() const { return answers_.met_no_answer(); }

  int evaluations() const { return answers_.count(); }
  std::exception_ptr failure() const { return answers_.failure(); }

 private:
  std::size_t rows() const { return static_cast<std::size_t>(num_residuals()); }
  /// Residuals at y; false where the model has no answer.
  bool residuals_at(const std::vector<double>& y, std::vector<double>& residuals) const;
  /// Both at y, kept; false where the model has no answer.
  bool with_jacobian_at(const std::vector<double>& y) const;
  /// What is kept becomes that of y, with a Jacobian where it comes along.
  bool look_at(const std::vector<double>& y) const;
  /// Adds differences to what is kept.
  bool take_differences() const;
  bool difference(std::vector<double>& y, std::size_t j, const std::vector<double>& centre,
                  std::vector<double>& slope) const;

  const CalibrationProblem& problem_;
  mutable ModelAnswers answers_;
  /// Ceres asks for the Jacobian where it has just had the residuals, and goes on from the last
  /// point that had one where a step is refused.
  mutable LinearModel last_, last_with_slopes_;
};

}  // namespace rebound
