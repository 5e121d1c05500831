#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <random>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/inference/calibration/evaluation_cache.hpp"
#include "comparisons/inference/calibration/identifiability.hpp"
#include "comparisons/inference/calibration/parted_search.hpp"
#include "comparisons/inference/calibration/profile.hpp"
#include "comparisons/inference/calibration/search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

void check(const CalibrationProblem& problem) {
  if (problem.parameters.empty())
    throw Error(ExitCode::bad_input, "a calibration needs at least one parameter");
  for (const auto& p : problem.parameters) {
    if (!(p.lowest < p.highest) || !(p.start >= p.lowest && p.start <= p.highest))
      throw Error(ExitCode::bad_input, "the start of '" + p.name + "' is outside its bounds",
                  {.key = p.name,
                   .value = std::to_string(p.start),
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

Optimum surroundings(const Attempt& best, const CalibrationCost& cost) {
  const auto rows = static_cast<Eigen::Index>(cost.num_residuals());
  const auto columns = static_cast<Eigen::Index>(best.y.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(rows, columns);
  Optimum optimum{
      Eigen::Map<const Eigen::VectorXd>(best.y.data(), columns), Eigen::VectorXd(rows), {}, {}};
  const double* at[] = {best.y.data()};
  double* out[] = {jacobian.data()};
  if (cost.met_no_answer()) cost.look_for_edges(best.y);
  if (!cost.Evaluate(at, optimum.residuals.data(), out)) {
    if (cost.failure()) std::rethrow_exception(cost.failure());
    throw Error(ExitCode::solver_failed, "the model has no answer around the estimates");
  }
  optimum.jacobian = jacobian;
  for (std::size_t j = 0; j < best.y.size(); ++j) optimum.at_edge.push_back(cost.at_edge(j));
  return optimum;
}

std::vector<double> start_of(const CalibrationProblem& problem) {
  std::vector<double> start;
  for (const auto& p : problem.parameters) start.push_back(p.start);
  return start;
}

/// Best of the searches from the given start and from seeded ones; `search` is one from a start.
template <class Search>
Attempt best_attempt(const CalibrationProblem& problem, const Search& search) {
  std::mt19937_64 generator(problem.controls.seed);
  Attempt best;
  for (int k = 0; k < std::max(1, problem.controls.starts); ++k) {
    std::vector<double> y;
    for (const auto& p : problem.parameters)
      y.push_back((k == 0 ? p.start : drawn_start(p, generator)) / p.scale);
    const Attempt attempt = search(std::move(y));
    if (attempt.interrupted)
      throw Error(ExitCode::interrupted, "the calibration was interrupted before it ended");
    // A drawn start where the model has no answer ends at once, unconverged.
    if (k == 0 || (attempt.converged && attempt.cost < best.cost)) best = attempt;
  }
  return best;
}

/// The fit of one set of residuals, without profiles.
CalibrationResult fit(const CalibrationProblem& problem, const std::vector<double>& first,
                      const RunControl& control) {
  CalibrationResult result;
  result.cost_before = half_square(first);
  const auto fill = [&](const Attempt& best, const Optimum& optimum, int evaluations) {
    result.cost_after = best.cost;
    result.converged = best.converged;
    assess(problem, optimum, result);
    result.evaluations = evaluations;
    return result;
  };
  if (falls_into_parts(problem)) {
    PartedSearch search(problem);
    const Attempt best = best_attempt(
        problem, [&](const std::vector<double>& y) { return search.from(y, control); });
    const Optimum optimum = search.surroundings(best.y);
    return fill(best, optimum, search.evaluations() + 1);
  }
  CalibrationCost cost(problem, static_cast<int>(first.size()));
  const Attempt best = best_attempt(problem, [&](std::vector<double> y) {
    return search_from(std::move(y), problem, cost, control);
  });
  const Optimum optimum = surroundings(best, cost);
  return fill(best, optimum, cost.evaluations() + 1);
}

/// The problem started from a fit's estimates.
CalibrationProblem restarted(CalibrationProblem problem, const CalibrationResult& from) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    auto& p = problem.parameters[i];
    p.start = std::clamp(from.estimates[i].value, p.lowest, p.highest);
  }
  return problem;
}

/// Fit with the robust loss. Where the noise is unknown it is measured on the
/// residuals, first of the ordinary fit, which wrong data have spoilt, then of
/// each robust one, until it settles.
CalibrationResult fit_robustly(CalibrationProblem& problem, std::size_t data,
                               const CalibrationResult& ordinary, const RunControl& control) {
  const CalibrationProblem plain = problem;
  const bool known = problem.noise == NoiseKnowledge::known;
  CalibrationResult result = ordinary;
  double last = 0.0;
  for (int round = 0; round < (known ? 1 : 20); ++round) {
    problem = restarted(plain, result);
    std::vector<double> residuals = problem.residuals(start_of(problem));
    residuals.resize(data);
    const double noise = known ? 1.0 : robust_deviation(std::move(residuals));
    // An exact fit has no wrong data.
    if (!(noise > 0.0) || std::abs(noise - last) <= 1e-3 * noise) break;
    problem = with_loss(problem, data, problem.controls.loss_scale * noise);
    result = fit(problem, problem.residuals(start_of(problem)), control);
    last = noise;
  }
  if (last > 0.0)
    problem = with_loss(restarted(plain, result), data, problem.controls.loss_scale * last);
  result.cost_before = ordinary.cost_before;
  return result;
}

/// Residuals and behind them their slopes, as one row of numbers, and back.
std::vector<double> flat(ResidualsWithJacobian with_jacobian) {
  with_jacobian.residuals.insert(with_jacobian.residuals.end(), with_jacobian.slopes.begin(),
                                 with_jacobian.slopes.end());
  return std::move(with_jacobian.residuals);
}
ResidualsWithJacobian parted(const std::vector<double>& row, std::size_t unknowns) {
  const auto middle = row.begin() + static_cast<std::ptrdiff_t>(row.size() / (1 + unknowns));
  return {{row.begin(), middle}, {middle, row.end()}};
}

/// The problem as its checkpoint sees it: what is cached of a model with slopes is both.
CalibrationProblem flattened(const CalibrationProblem& problem) {
  CalibrationProblem one = problem;
  if (problem.with_jacobian)
    one.residuals = [with_jacobian = problem.with_jacobian](const std::vector<double>& x) {
      return flat(with_jacobian(x));
    };
  return one;
}
void answer_from(EvaluationCache& memory, CalibrationProblem& problem) {
  const bool with_jacobian = static_cast<bool>(problem.with_jacobian);
  const std::size_t unknowns = problem.parameters.size();
  problem.residuals = [&memory, with_jacobian, unknowns](const std::vector<double>& x) {
    return with_jacobian ? parted(memory(x), unknowns).residuals : memory(x);
  };
  if (with_jacobian)
    problem.with_jacobian = [&memory, unknowns](const std::vector<double>& x) {
      return parted(memory(x), unknowns);
    };
}

CalibrationResult fit_all(CalibrationProblem problem, const std::vector<double>& first,
                          std::size_t data, const RunControl& control) {
  CalibrationResult result = fit(problem, first, control);
  if (problem.controls.loss != RobustLoss::none)
    result = fit_robustly(problem, data, result, control);
  // A fit down to rounding leaves no noise to estimate a likelihood by.
  const bool exact =
      problem.noise == NoiseKnowledge::estimated && result.cost_after <= 1e-12 * result.cost_before;
  if (problem.controls.profiles == Profiles::each_parameter && !exact && result.converged) {
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
      result.estimates[i].profile = profile_of(problem, result, i, control);
      judge_profile(problem, i, result);
    }
    result.warnings.clear();
    conclude(problem, result);
  }
  result.data = static_cast<int>(data);
  return result;
}

}  // namespace

CalibrationResult calibrate(const CalibrationProblem& problem, const RunControl& control) {
  check(problem);
  const std::vector<double> start = start_of(problem);
  CalibrationProblem whole = with_priors(problem);
  const std::vector<double> first = whole.residuals(start);
  const auto priors = std::count_if(problem.parameters.begin(), problem.parameters.end(),
                                    [](const auto& p) { return p.prior.has_value(); });
  const std::size_t data = first.size() - static_cast<std::size_t>(priors);
  if (first.size() < start.size())
    throw Error(ExitCode::bad_input, "fewer data than parameters: nothing can be calibrated");
  if (!std::isfinite(half_square(first)))
    throw Error(ExitCode::bad_input, "the residuals at the start are not finite");
  if (problem.controls.checkpoint.empty()) return fit_all(std::move(whole), first, data, control);

  EvaluationCache memory(flattened(whole),
                         whole.with_jacobian ? flat(whole.with_jacobian(start)) : first);
  answer_from(memory, whole);
  try {
    CalibrationResult result = fit_all(whole, first, data, control);
    memory.save();
    return result;
  } catch (...) {
    memory.save();
    throw;
  }
}

}  // namespace rebound
