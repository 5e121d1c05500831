#include "comparisons/inference/calibration/calibration_cost.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rebound {

CalibrationCost::CalibrationCost(const CalibrationProblem& problem, int residuals)
    : problem_(problem), answers_(problem) {
  set_num_residuals(residuals);
  mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters.size()));
}

bool CalibrationCost::residuals_at(const std::vector<double>& y,
                                   std::vector<double>& residuals) const {
  return answers_.ask(y, rows(), problem_.residuals, residuals);
}

bool CalibrationCost::with_jacobian_at(const std::vector<double>& y) const {
  LinearModel found{.y = y, .residuals = {}, .slopes = {}};
  const auto model = [&](const std::vector<double>& x) {
    ResidualsWithJacobian both = problem_.with_jacobian(x);
    found.slopes = std::move(both.slopes);
    return std::move(both.residuals);
  };
  if (!answers_.ask(y, rows(), model, found.residuals)) return false;
  last_ = std::move(found);
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = j; i < last_.slopes.size(); i += y.size())
      last_.slopes[i] *= problem_.parameters[j].scale;
  return std::all_of(last_.slopes.begin(), last_.slopes.end(),
                     [](double slope) { return std::isfinite(slope); });
}

bool CalibrationCost::difference(std::vector<double>& y, std::size_t j,
                                 const std::vector<double>& centre,
                                 std::vector<double>& slope) const {
  answers_.forget_edge(j);
  return answers_.difference(y, j, problem_.residuals, centre, slope);
}

void CalibrationCost::look_for_edges(const std::vector<double>& y) const {
  std::vector<double> at = y, centre, slope;
  if (!residuals_at(at, centre)) return;
  for (std::size_t j = 0; j < y.size(); ++j) difference(at, j, centre, slope);
}

bool CalibrationCost::take_differences() const {
  const std::size_t unknowns = last_.y.size(), rows = last_.residuals.size();
  std::vector<double> y = last_.y, slope, slopes(rows * unknowns);
  for (std::size_t j = 0; j < unknowns; ++j) {
    if (!difference(y, j, last_.residuals, slope)) return false;
    for (std::size_t i = 0; i < rows; ++i) slopes[i * unknowns + j] = slope[i];
  }
  last_.slopes = std::move(slopes);
  return true;
}

bool CalibrationCost::look_at(const std::vector<double>& y) const {
  if (y == last_with_slopes_.y) {
    last_ = last_with_slopes_;
    return true;
  }
  if (problem_.with_jacobian && !problem_.controls.runs_are_dear) return with_jacobian_at(y);
  std::vector<double> residuals;
  if (!residuals_at(y, residuals)) return false;
  last_ = {.y = y, .residuals = std::move(residuals), .slopes = {}};
  return true;
}

bool CalibrationCost::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  if (answers_.failure()) return false;
  const std::vector<double> y(parameters[0], parameters[0] + problem_.parameters.size());
  if (y != last_.y && !look_at(y)) return false;
  std::copy(last_.residuals.begin(), last_.residuals.end(), residuals);
  if (!jacobians || !jacobians[0]) return true;
  if (last_.slopes.empty() && !(problem_.with_jacobian ? with_jacobian_at(y) : take_differences()))
    return false;
  last_with_slopes_ = last_;
  std::copy(last_.slopes.begin(), last_.slopes.end(), jacobians[0]);
  return true;
}

}  // namespace rebound
