#include "comparisons/inference/calibration/search.hpp"

#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <algorithm>
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
    if (summary.iteration > 0) ++taken_;
    if (control_.progress) control_.progress(static_cast<double>(taken_) / iterations_);
    if (control_.interrupted && control_.interrupted()) return ceres::SOLVER_ABORT;
    if (taken_ == 0) first_cost_ = summary.cost;
    // Where residuals vanish, the share by which the cost changes never gets small.
    if (summary.cost < exact_ * first_cost_) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    return ceres::SOLVER_CONTINUE;
  }

 private:
  const RunControl& control_;
  int iterations_;
  double exact_;  ///< cost over the first one
  double first_cost_ = 0.0;
  int taken_ = 0;  ///< iterations, of all parts of a search
};

enum class Bound { neither, lower, upper };

Bound bound_at(const CalibrationParameter& p, double y) {
  const double low = p.lowest / p.scale, high = p.highest / p.scale, near = 1e-9 * (high - low);
  return y >= high - near ? Bound::upper : y <= low + near ? Bound::lower : Bound::neither;
}

/// The end of one part of a search, to first order.
struct EndOfSearch {
  std::vector<std::size_t> held;  ///< unknowns at a bound that hides the least
  double gain = 0.0;              ///< in cost, of a whole Gauss–Newton step of the others
};

EndOfSearch end_at(const std::vector<double>& y, const CalibrationProblem& problem,
                   CalibrationCost& cost) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::VectorXd residuals(cost.num_residuals());
  Matrix slopes(residuals.size(), static_cast<Eigen::Index>(y.size()));
  const double* at[] = {y.data()};
  double* out[] = {slopes.data()};
  EndOfSearch end;
  if (!cost.Evaluate(at, residuals.data(), out)) return end;
  std::vector<Eigen::Index> others;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double slope = residuals.dot(slopes.col(static_cast<Eigen::Index>(j)));
    const Bound bound = bound_at(problem.parameters[j], y[j]);
    if ((bound == Bound::upper && slope < 0.0) || (bound == Bound::lower && slope > 0.0))
      end.held.push_back(j);
    else
      others.push_back(static_cast<Eigen::Index>(j));
  }
  if (others.empty()) return end;
  const Eigen::MatrixXd free = slopes(Eigen::all, others);
  const Eigen::VectorXd left = residuals - free * free.colPivHouseholderQr().solve(residuals);
  end.gain = 0.5 * (residuals.squaredNorm() - left.squaredNorm());
  return end;
}

/// Stops where a step has brought an unknown to a bound at which it is not held.
class StopAtBounds final : public ceres::IterationCallback {
 public:
  StopAtBounds(const CalibrationProblem& problem, const std::vector<double>& y,
               const std::vector<std::size_t>& held)
      : problem_(problem), y_(y), held_(held) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (summary.iteration == 0 || !summary.step_is_successful) return ceres::SOLVER_CONTINUE;
    for (std::size_t j = 0; j < y_.size(); ++j)
      if (bound_at(problem_.parameters[j], y_[j]) != Bound::neither &&
          std::find(held_.begin(), held_.end(), j) == held_.end()) {
        stopped_ = true;
        return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
      }
    return ceres::SOLVER_CONTINUE;
  }
  bool stopped() const { return stopped_; }

 private:
  const CalibrationProblem& problem_;
  const std::vector<double>& y_;
  const std::vector<std::size_t>& held_;
  bool stopped_ = false;
};

/// May a search end here? Its short first steps damp what moves many unknowns together and changes
/// the residuals little: along such a valley a step gains less than the tolerance far from the end.
/// Half a unit of χ² is worth no more runs: no choice between models hangs on it.
bool at_the_end_of_a_valley(const ceres::Solver::Summary& summary, const EndOfSearch& end,
                            const CalibrationProblem& problem) {
  constexpr double whole_steps = 1e4;  // radius of the trust region
  const double worth_it = problem.noise == NoiseKnowledge::known ? 0.25 : 0.0;
  return summary.iterations.back().trust_region_radius >= whole_steps ||
         end.gain <= std::max(worth_it, problem.controls.cost_tolerance * summary.final_cost);
}

/// What Ceres may move of so many unknowns; nothing: all of them.
ceres::Manifold* without(const std::vector<std::size_t>& held, std::size_t unknowns) {
  if (held.empty()) return nullptr;
  return new ceres::SubsetManifold(static_cast<int>(unknowns), {held.begin(), held.end()});
}

/// Ceres cuts off a step at a bound and leaves the other unknowns where a longer one would have
/// taken them: a search crawls there. What a bound holds is held, as long as it does, and the
/// others go on without it. Steps get longer where the search would end in a valley.
ceres::Solver::Summary search_with_few_runs(ceres::Problem& search, ceres::Solver::Options options,
                                            std::vector<double>& y,
                                            const CalibrationProblem& problem,
                                            CalibrationCost& cost) {
  options.update_state_every_iteration = true;
  const std::vector<ceres::IterationCallback*> callbacks = options.callbacks;
  const double tolerance = problem.controls.cost_tolerance;
  std::vector<std::size_t> held = end_at(y, problem, cost).held;
  bool with_longer_steps = false;
  while (true) {
    StopAtBounds stop(problem, y, held);
    options.callbacks = callbacks;
    options.callbacks.push_back(&stop);
    const bool any_free = held.size() < y.size();
    if (!any_free) options.max_num_iterations = 0;
    search.SetManifold(y.data(), any_free ? without(held, y.size()) : nullptr);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &search, &summary);
    if (!any_free && summary.termination_type == ceres::NO_CONVERGENCE)
      summary.termination_type = ceres::CONVERGENCE;
    if (stop.stopped()) summary.termination_type = ceres::NO_CONVERGENCE;
    const int taken = static_cast<int>(summary.iterations.size()) - 1;
    options.max_num_iterations -= std::max(1, taken);
    if (cost.failure() || summary.termination_type == ceres::USER_FAILURE || taken < 0 ||
        options.max_num_iterations <= 0)
      return summary;
    EndOfSearch end = end_at(y, problem, cost);
    const bool ended = !stop.stopped() && end.held == held;
    const bool gained = summary.initial_cost - summary.final_cost > tolerance * summary.final_cost;
    if (ended && (at_the_end_of_a_valley(summary, end, problem) || (with_longer_steps && !gained)))
      return summary;
    held = std::move(end.held);
    with_longer_steps = ended;
    constexpr double longer = 100.0;
    options.initial_trust_region_radius =
        (ended ? longer : 1.0) * summary.iterations.back().trust_region_radius;
  }
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
  if (problem.controls.runs_are_dear)
    summary = search_with_few_runs(search, options, y, problem, cost);
  else
    ceres::Solve(options, &search, &summary);
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
