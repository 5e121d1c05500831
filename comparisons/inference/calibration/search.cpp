#include "comparisons/inference/calibration/search.hpp"

#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <exception>

#include "comparisons/inference/calibration/ceres_search.hpp"

namespace rebound {

namespace {

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
  ceres::Problem search(search_ownership());
  search.AddResidualBlock(&cost, nullptr, y.data());
  for (std::size_t i = 0; i < y.size(); ++i) bound(search, y.data(), i, problem.parameters[i]);
  ceres::Solver::Options options = search_options(problem.controls);
  if (problem.controls.runs_are_dear) {
    options.initial_trust_region_radius = 1.0;
    options.max_num_line_search_step_size_iterations = 1;
  }
  ProgressCallback callback(control, problem.controls);
  options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  if (problem.controls.runs_are_dear)
    summary = search_with_few_runs(search, options, y, problem, cost);
  else
    ceres::Solve(options, &search, &summary);
  if (cost.failure()) std::rethrow_exception(cost.failure());
  return attempt_of(summary, std::move(y));
}

double half_square(const std::vector<double>& residuals) {
  double sum = 0.0;
  for (double one : residuals) sum += 0.5 * one * one;
  return sum;
}

}  // namespace rebound
