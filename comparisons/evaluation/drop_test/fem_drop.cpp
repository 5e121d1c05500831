#include "comparisons/evaluation/drop_test/fem_drop.hpp"

#include <cmath>

#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/inference/calibration/material_numbers.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double difference = 0.05;  // of a number; FE is smooth to about 1e-4 in restitution

double restitution_of(const FemProblem& problem, const FemRunner& run) {
  const FemResult result = run(problem);
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  return result.scalars.restitution;
}

/// ∂e/∂ln p of every number.
std::vector<double> slopes_of(const FemProblem& problem, const std::vector<std::string>& names,
                              const FemRunner& run) {
  const auto numbers = material_numbers(problem.material, 1.0);
  std::vector<FreeMaterialNumber> free;
  free.reserve(names.size());
  for (const auto& name : names) free.push_back(find_material_number(numbers, name));
  std::vector<double> found(2 * free.size());
  in_parallel(found.size(), [&](std::size_t i) {
    FemProblem moved = problem;
    number_of(moved.material, free[i / 2]) *= i % 2 == 0 ? 1.0 + difference : 1.0 - difference;
    found[i] = restitution_of(moved, run);
  });
  std::vector<double> slopes;
  const double span = std::log((1.0 + difference) / (1.0 - difference));
  for (std::size_t i = 0; i < free.size(); ++i)
    slopes.push_back((found[2 * i] - found[2 * i + 1]) / span);
  return slopes;
}

void carry(const FemProblem& problem, const ParameterUncertainty& u, const FemRunner& run,
           const DropOptions& options, DropOutcome& outcome) {
  const std::size_t count = u.names.size();
  if (u.standard_errors.size() != count || u.correlation.size() != count)
    throw Error(
        ExitCode::bad_input, "the calibration has no covariance: a parameter is not identifiable",
        {.key = "correlation", .value = "", .allowed = "a calibration that identifies all"});
  const std::vector<double> slopes = slopes_of(problem, u.names, run);
  Material material = problem.material;
  const auto numbers = material_numbers(material, 1.0);
  std::vector<double> reach;
  for (std::size_t i = 0; i < count; ++i)
    reach.push_back(slopes[i] * u.standard_errors[i] /
                    number_of(material, find_material_number(numbers, u.names[i])));
  double variance = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      variance += reach[i] * reach[j] * u.correlation[i].at(j);
  if (!std::isfinite(variance))
    throw Error(ExitCode::bad_input, "a standard error of the calibration is not finite");
  const double deviation = std::sqrt(std::max(variance, 0.0));
  const double z = normal_quantile(0.5 * (1.0 + options.confidence));
  outcome.interval = {outcome.restitution - z * deviation, outcome.restitution + z * deviation};
  outcome.notes.emplace_back("the interval carries the material's uncertainty to first order");
  if (deviation == 0.0) return;
  const Regulation band;
  outcome.probability_inside =
      normal_chance_below((band.highest - outcome.restitution) / deviation) -
      normal_chance_below((band.lowest - outcome.restitution) / deviation);
}

}  // namespace

DropOutcome drop_test(const FemProblem& problem,
                      const std::optional<ParameterUncertainty>& uncertainty, const FemRunner& run,
                      const DropOptions& options) {
  check(options);
  FemProblem drop = problem;
  drop.impact.speed = drop_speed(options.height);
  DropOutcome outcome;
  outcome.speed = drop.impact.speed;
  outcome.restitution = restitution_of(drop, run);
  if (uncertainty)
    carry(drop, *uncertainty, run, options, outcome);
  else
    outcome.notes.emplace_back("no interval: the model states no uncertainty of its material");
  outcome.verdict = verdict_of(outcome.restitution, outcome.interval);
  return outcome;
}

}  // namespace rebound
