#include "comparisons/inference/calibration/ceres_search.hpp"

#include <glog/logging.h>

#include <utility>

namespace rebound {
namespace {

/// Ceres logs to standard error; its summary says it all. Once: searches run side by side.
void keep_ceres_quiet() {
  [[maybe_unused]] static const int level = FLAGS_minloglevel = google::GLOG_FATAL;
}

}  // namespace

ProgressCallback::ProgressCallback(const RunControl& control, const CalibrationControls& controls)
    : control_(control),
      iterations_(controls.iterations),
      exact_(controls.cost_tolerance * controls.cost_tolerance) {}

ceres::CallbackReturnType ProgressCallback::operator()(const ceres::IterationSummary& summary) {
  if (summary.iteration > 0) ++taken_;
  if (control_.progress) control_.progress(static_cast<double>(taken_) / iterations_);
  if (control_.interrupted && control_.interrupted()) return ceres::SOLVER_ABORT;
  if (taken_ == 0) first_cost_ = summary.cost;
  // Where residuals vanish, the share by which the cost changes never gets small.
  if (summary.cost < exact_ * first_cost_) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  return ceres::SOLVER_CONTINUE;
}

ceres::Problem::Options search_ownership() {
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;  // the cost refuses what is not finite itself
  return ownership;
}

ceres::Solver::Options search_options(const CalibrationControls& controls) {
  keep_ceres_quiet();
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = controls.iterations;
  options.function_tolerance = controls.cost_tolerance;
  options.parameter_tolerance = 1e-10;
  options.num_threads = 1;
  // Bounds make Ceres search along each step; with cubic interpolation it would ask for a whole
  // Jacobian at every point of that line.
  options.line_search_interpolation_type = ceres::QUADRATIC;
  return options;
}

void bound(ceres::Problem& search, double* y, std::size_t i, const CalibrationParameter& unknown) {
  const int index = static_cast<int>(i);
  search.SetParameterLowerBound(y, index, unknown.lowest / unknown.scale);
  search.SetParameterUpperBound(y, index, unknown.highest / unknown.scale);
}

Attempt attempt_of(const ceres::Solver::Summary& summary, std::vector<double> y) {
  const bool converged = summary.termination_type == ceres::CONVERGENCE ||
                         summary.termination_type == ceres::USER_SUCCESS;
  return {std::move(y), summary.final_cost, converged,
          summary.termination_type == ceres::USER_FAILURE};
}

}  // namespace rebound
