#include "comparisons/inference/calibration/calibration_cost.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

CalibrationCost::CalibrationCost(const CalibrationProblem& problem, int residuals)
    : problem_(problem), edge_(problem.parameters.size(), false) {
  set_num_residuals(residuals);
  mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters.size()));
}

template <class Model>
bool CalibrationCost::answered(const std::vector<double>& y, const Model& model) const {
  if (failure_) return false;
  std::vector<double> x(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) x[i] = y[i] * problem_.parameters[i].scale;
  ++evaluations_;
  bool found = false;
  try {
    const std::vector<double>& residuals = model(x);
    if (residuals.size() != static_cast<std::size_t>(num_residuals()))
      throw Error(ExitCode::bad_input, "the number of residuals changed with the parameters");
    found =
        std::all_of(residuals.begin(), residuals.end(), [](double r) { return std::isfinite(r); });
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) failure_ = std::current_exception();
  } catch (...) {
    failure_ = std::current_exception();
  }
  if (!found) met_no_answer_ = true;
  return found;
}

bool CalibrationCost::residuals_at(const std::vector<double>& y,
                                   std::vector<double>& residuals) const {
  return answered(y, [&](const std::vector<double>& x) -> const std::vector<double>& {
    return residuals = problem_.residuals(x);
  });
}

bool CalibrationCost::with_jacobian_at(const std::vector<double>& y) const {
  ResidualsWithJacobian found;
  const bool any = answered(y, [&](const std::vector<double>& x) -> const std::vector<double>& {
    found = problem_.with_jacobian(x);
    return found.residuals;
  });
  if (!any) return false;
  last_ = {.y = y, .residuals = std::move(found.residuals), .slopes = std::move(found.slopes)};
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = j; i < last_.slopes.size(); i += y.size())
      last_.slopes[i] *= problem_.parameters[j].scale;
  return std::all_of(last_.slopes.begin(), last_.slopes.end(),
                     [](double slope) { return std::isfinite(slope); });
}

void CalibrationCost::look_for_edges(const std::vector<double>& y) const {
  std::vector<double> at = y, centre, slope;
  if (!residuals_at(at, centre)) return;
  for (std::size_t j = 0; j < y.size(); ++j) difference(at, j, centre, slope);
}

bool CalibrationCost::difference(std::vector<double>& y, std::size_t j,
                                 const std::vector<double>& centre,
                                 std::vector<double>& slope) const {
  const auto& parameter = problem_.parameters[j];
  const double step = problem_.controls.relative_step, here = y[j];
  std::vector<double> above, below;
  edge_[j] = false;
  const auto side = [&](double at, std::vector<double>& out) {
    if (at * parameter.scale > parameter.highest || at * parameter.scale < parameter.lowest)
      return false;
    y[j] = at;
    const bool found = residuals_at(y, out);
    y[j] = here;
    if (!found) edge_[j] = true;
    return found;
  };
  const bool has_above = side(here + step, above);
  const bool enough = has_above && problem_.controls.differences == Differences::one_sided;
  const bool has_below = !enough && side(here - step, below);
  if (!has_above && !has_below) return false;
  const auto& high = has_above ? above : centre;
  const auto& low = has_below ? below : centre;
  const double width = step * ((has_above ? 1.0 : 0.0) + (has_below ? 1.0 : 0.0));
  slope.resize(centre.size());
  for (std::size_t i = 0; i < centre.size(); ++i) slope[i] = (high[i] - low[i]) / width;
  return true;
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
  if (failure_) return false;
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
