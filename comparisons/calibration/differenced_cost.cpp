#include "comparisons/calibration/differenced_cost.hpp"

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

DifferencedCost::DifferencedCost(const CalibrationProblem& problem, int residuals)
    : problem_(problem), edge_(problem.parameters.size(), false) {
  set_num_residuals(residuals);
  mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.parameters.size()));
}

bool DifferencedCost::residuals_at(const std::vector<double>& y,
                                   std::vector<double>& residuals) const {
  if (failure_) return false;
  std::vector<double> x(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) x[i] = y[i] * problem_.parameters[i].scale;
  ++evaluations_;
  try {
    residuals = problem_.residuals(x);
    if (residuals.size() != static_cast<std::size_t>(num_residuals()))
      throw Error(ExitCode::bad_input, "the number of residuals changed with the parameters");
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) failure_ = std::current_exception();
    return false;
  } catch (...) {
    failure_ = std::current_exception();
    return false;
  }
  for (double r : residuals)
    if (!std::isfinite(r)) return false;
  return true;
}

bool DifferencedCost::difference(std::vector<double>& y, std::size_t j,
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
  const bool has_above = side(here + step, above), has_below = side(here - step, below);
  if (!has_above && !has_below) return false;
  const auto& high = has_above ? above : centre;
  const auto& low = has_below ? below : centre;
  const double width = step * ((has_above ? 1.0 : 0.0) + (has_below ? 1.0 : 0.0));
  slope.resize(centre.size());
  for (std::size_t i = 0; i < centre.size(); ++i) slope[i] = (high[i] - low[i]) / width;
  return true;
}

bool DifferencedCost::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  const std::size_t unknowns = problem_.parameters.size();
  std::vector<double> y(parameters[0], parameters[0] + unknowns), centre, slope;
  if (failure_) return false;
  if (y == last_y_) {
    centre = last_residuals_;
  } else {
    if (!residuals_at(y, centre)) return false;
    last_y_ = y;
    last_residuals_ = centre;
  }
  std::copy(centre.begin(), centre.end(), residuals);
  if (!jacobians || !jacobians[0]) return true;
  for (std::size_t j = 0; j < unknowns; ++j) {
    if (!difference(y, j, centre, slope)) return false;
    for (std::size_t i = 0; i < centre.size(); ++i) jacobians[0][i * unknowns + j] = slope[i];
  }
  return true;
}

}  // namespace rebound
