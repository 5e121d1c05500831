#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>
#include <glog/logging.h>

#include <cmath>
#include <random>

#include "comparisons/calibration/calibration_problem.hpp"
#include "comparisons/calibration/differenced_cost.hpp"
#include "comparisons/calibration/identifiability.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// Stops Ceres when the user asks, and tells how far it is.
class Watch final : public ceres::IterationCallback {
 public:
  Watch(const RunControl& control, int iterations) : control_(control), iterations_(iterations) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (control_.progress) control_.progress(static_cast<double>(summary.iteration) / iterations_);
    if (control_.interrupted && control_.interrupted()) return ceres::SOLVER_ABORT;
    return ceres::SOLVER_CONTINUE;
  }

 private:
  const RunControl& control_;
  int iterations_;
};

void check(const CalibrationProblem& problem) {
  if (problem.parameters.empty())
    throw Error(ExitCode::bad_input, "a calibration needs at least one parameter");
  for (const auto& p : problem.parameters) {
    if (!(p.lowest < p.highest) || !(p.start >= p.lowest && p.start <= p.highest))
      throw Error(ExitCode::bad_input, "the start of '" + p.name + "' is outside its bounds",
                  {.key = p.name, .value = std::to_string(p.start),
                   .allowed = fmt::format("[{}, {}]", p.lowest, p.highest)});
    if (!(p.scale > 0.0) || !std::isfinite(p.scale))
      throw Error(ExitCode::bad_input, "the scale of '" + p.name + "' must be positive",
                  {.key = p.name, .value = std::to_string(p.scale), .allowed = "> 0"});
  }
}

/// A start within the bounds, in proportion where they are of one sign. Drawn
/// from the generator's bits, so that a seed means the same everywhere.
double drawn_start(const CalibrationParameter& p, std::mt19937_64& generator) {
  const double u = static_cast<double>(generator() >> 11) * 0x1p-53;
  if (p.lowest > 0.0) return p.lowest * std::pow(p.highest / p.lowest, u);
  return p.lowest + u * (p.highest - p.lowest);
}

struct Attempt {
  std::vector<double> y;
  double cost = 0.0;
  bool converged = false;
  bool interrupted = false;
};

Attempt search_from(std::vector<double> y, const CalibrationProblem& problem,
                    DifferencedCost& cost, const RunControl& control) {
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem search(ownership);
  search.AddResidualBlock(&cost, nullptr, y.data());
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto& p = problem.parameters[i];
    search.SetParameterLowerBound(y.data(), static_cast<int>(i), p.lowest / p.scale);
    search.SetParameterUpperBound(y.data(), static_cast<int>(i), p.highest / p.scale);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = problem.controls.iterations;
  options.function_tolerance = problem.controls.cost_tolerance;
  options.parameter_tolerance = 1e-10;
  options.num_threads = 1;
  Watch watch(control, problem.controls.iterations);
  options.callbacks.push_back(&watch);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &search, &summary);
  if (cost.failure()) std::rethrow_exception(cost.failure());
  return {std::move(y), summary.final_cost, summary.termination_type == ceres::CONVERGENCE,
          summary.termination_type == ceres::USER_FAILURE};
}

Optimum surroundings(const Attempt& best, const DifferencedCost& cost) {
  const auto rows = static_cast<Eigen::Index>(cost.num_residuals());
  const auto columns = static_cast<Eigen::Index>(best.y.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(rows, columns);
  Optimum optimum{Eigen::Map<const Eigen::VectorXd>(best.y.data(), columns),
                  Eigen::VectorXd(rows), {}};
  const double* at[] = {best.y.data()};
  double* out[] = {jacobian.data()};
  if (!cost.Evaluate(at, optimum.residuals.data(), out)) {
    if (cost.failure()) std::rethrow_exception(cost.failure());
    throw Error(ExitCode::solver_failed, "the model has no answer around the estimates");
  }
  optimum.jacobian = jacobian;
  return optimum;
}

}  // namespace

CalibrationResult calibrate(const CalibrationProblem& problem, const RunControl& control) {
  check(problem);
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres logs to standard error; its summary says it all
  std::vector<double> start;
  for (const auto& p : problem.parameters) start.push_back(p.start);
  const std::vector<double> first = problem.residuals(start);
  if (first.size() < start.size())
    throw Error(ExitCode::bad_input, "fewer data than parameters: nothing can be calibrated");
  CalibrationResult result;
  for (double r : first) result.cost_before += 0.5 * r * r;
  if (!std::isfinite(result.cost_before))
    throw Error(ExitCode::bad_input, "the residuals at the start are not finite");

  DifferencedCost cost(problem, static_cast<int>(first.size()));
  std::mt19937_64 generator(problem.controls.seed);
  Attempt best;
  for (int k = 0; k < std::max(1, problem.controls.starts) && !best.interrupted; ++k) {
    std::vector<double> y;
    for (const auto& p : problem.parameters)
      y.push_back((k == 0 ? p.start : drawn_start(p, generator)) / p.scale);
    const Attempt attempt = search_from(std::move(y), problem, cost, control);
    // A drawn start where the model has no answer ends at once, unconverged.
    if (k == 0 || attempt.interrupted || (attempt.converged && attempt.cost < best.cost))
      best = k > 0 && attempt.interrupted ? Attempt{best.y, best.cost, best.converged, true}
                                          : attempt;
  }
  if (best.interrupted)
    throw Error(ExitCode::interrupted, "the calibration was interrupted before it ended");
  result.cost_after = best.cost;
  result.converged = best.converged;
  assess(problem, surroundings(best, cost), result);
  result.evaluations = cost.evaluations() + 1;
  return result;
}

}  // namespace rebound
