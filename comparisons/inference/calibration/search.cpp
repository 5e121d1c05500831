#include "comparisons/inference/calibration/search.hpp"

#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <exception>

namespace rebound {

namespace {

/// Ceres logs to standard error; its summary says it all. Once: searches run side by side.
void keep_ceres_quiet() {
  [[maybe_unused]] static const int level = FLAGS_minloglevel = google::GLOG_FATAL;
}

/// Stops Ceres when the user asks or the fit is exact, and tells how far it is.
class ProgressCallback final : public ceres::IterationCallback {
 public:
  ProgressCallback(const RunControl& control, const CalibrationControls& controls)
      : control_(control),
        iterations_(controls.iterations),
        exact_(controls.cost_tolerance * controls.cost_tolerance) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (control_.progress) control_.progress(static_cast<double>(summary.iteration) / iterations_);
    if (control_.interrupted && control_.interrupted()) return ceres::SOLVER_ABORT;
    if (summary.iteration == 0) first_cost_ = summary.cost;
    // Where residuals vanish, the share by which the cost changes never gets small.
    if (summary.cost < exact_ * first_cost_) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    return ceres::SOLVER_CONTINUE;
  }

 private:
  const RunControl& control_;
  int iterations_;
  double exact_;  ///< cost over the first one
  double first_cost_ = 0.0;
};

/// Is the least beyond this bound, as the slope of the cost says?
bool wants_beyond(const CalibrationParameter& p, double y, double slope) {
  const double low = p.lowest / p.scale, high = p.highest / p.scale, near = 1e-9 * (high - low);
  return (y >= high - near && slope < 0.0) || (y <= low + near && slope > 0.0);
}

/// Unknowns at a bound that hides the least, y being where a search has ended.
std::vector<int> at_their_bounds(std::vector<double>& y, const CalibrationProblem& problem,
                                 CalibrationCost& cost) {
  const auto rows = static_cast<std::size_t>(cost.num_residuals());
  std::vector<double> residuals(rows), slopes(rows * y.size());
  const double* at[] = {y.data()};
  double* out[] = {slopes.data()};
  std::vector<int> held;
  if (!cost.Evaluate(at, residuals.data(), out)) return held;
  for (std::size_t j = 0; j < y.size(); ++j) {
    double slope = 0.0;
    for (std::size_t i = 0; i < rows; ++i) slope += residuals[i] * slopes[i * y.size() + j];
    if (wants_beyond(problem.parameters[j], y[j], slope)) held.push_back(static_cast<int>(j));
  }
  return held;
}

}  // namespace

Attempt search_from(std::vector<double> y, const CalibrationProblem& problem, CalibrationCost& cost,
                    const RunControl& control) {
  keep_ceres_quiet();
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;  // the cost refuses what is not finite itself
  ceres::Problem search(ownership);
  search.AddResidualBlock(&cost, nullptr, y.data());
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto& p = problem.parameters[i];
    search.SetParameterLowerBound(y.data(), static_cast<int>(i), p.lowest / p.scale);
    search.SetParameterUpperBound(y.data(), static_cast<int>(i), p.highest / p.scale);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = problem.controls.iterations;
  options.function_tolerance = problem.controls.cost_tolerance;
  options.parameter_tolerance = 1e-10;
  options.num_threads = 1;
  if (problem.controls.runs_are_dear) {
    options.initial_trust_region_radius = 1.0;
    options.max_num_line_search_step_size_iterations = 1;
  }
  // Bounds make Ceres search along each step; with cubic interpolation it would ask for a whole
  // Jacobian at every point of that line.
  options.line_search_interpolation_type = ceres::QUADRATIC;
  ProgressCallback callback(control, problem.controls);
  options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &search, &summary);
  // Steps that a bound cuts off lead the others astray: a search ends early there. What the bound
  // holds is left where it is, and the rest goes on.
  const int left = problem.controls.iterations - static_cast<int>(summary.iterations.size()) + 1;
  if (problem.controls.runs_are_dear && !cost.failure() && left > 0 &&
      summary.termination_type != ceres::USER_FAILURE) {
    const std::vector<int> held = at_their_bounds(y, problem, cost);
    if (!held.empty() && held.size() < y.size()) {
      search.SetManifold(y.data(), new ceres::SubsetManifold(static_cast<int>(y.size()), held));
      options.max_num_iterations = left;
      ceres::Solve(options, &search, &summary);
    }
  }
  if (cost.failure()) std::rethrow_exception(cost.failure());
  const bool converged = summary.termination_type == ceres::CONVERGENCE ||
                         summary.termination_type == ceres::USER_SUCCESS;
  return {std::move(y), summary.final_cost, converged,
          summary.termination_type == ceres::USER_FAILURE};
}

double half_square(const std::vector<double>& residuals) {
  double sum = 0.0;
  for (double one : residuals) sum += 0.5 * one * one;
  return sum;
}

}  // namespace rebound
