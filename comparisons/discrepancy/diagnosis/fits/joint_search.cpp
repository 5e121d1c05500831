#include "comparisons/discrepancy/diagnosis/fits/joint_search.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "comparisons/inference/calibration/differences.hpp"

namespace rebound {
namespace {

CalibrationResult search_at(CalibrationProblem& problem, const std::vector<double>& start,
                            const RunControl& control) {
  start_at(start, problem);
  return calibrate(problem, control);
}

/// One by its card: a jump that is small in each record is large in all of them together.
bool has_an_effect_that_jumps(const JointModel& model) {
  const std::vector<EffectChoice>& effects = model.hypothesis().effects;
  return std::any_of(effects.begin(), effects.end(), [](const EffectChoice& one) {
    return find_effect(one.name).card.jumps_at_touch;
  });
}

}  // namespace

double left_of(const JointModel& model, const std::vector<double>& values) {
  const std::vector<double> residuals = model.residuals(values);
  return std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
}

void start_at(const std::vector<double>& values, CalibrationProblem& problem) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    CalibrationParameter& unknown = problem.parameters[i];
    unknown.start = std::clamp(values[i], unknown.lowest, unknown.highest);
  }
}

CalibrationControls search_controls(const JointModel& model) {
  return {.relative_step = model.difference_step(),
          .differences = Differences::one_sided,
          .runs_are_dear = model.fem() != nullptr,
          .cost_tolerance = model.fem() ? 3e-4 : 1e-7,
          .iterations = model.fem() ? 25 : 60};
}

CalibrationResult search_joint_model(const JointModel& model, CalibrationProblem& problem,
                                     const RunControl& control) {
  std::vector<double> start;
  for (const CalibrationParameter& unknown : problem.parameters) start.push_back(unknown.start);
  CalibrationResult best = search_at(problem, start, control);
  // A believed law whose damping ends at its bound rises as steeply, and has no other start.
  if (model.effects_at(start).empty()) return best;
  if (const std::vector<double> at_jumps = model.with_starts_at_jumps(start); at_jumps != start) {
    CalibrationResult other = search_at(problem, at_jumps, control);
    if (other.cost_after < best.cost_after) best = std::move(other);
  }
  // Where the force rises smoothly slopes tell the start, and a further search gains nothing.
  if (!has_an_effect_that_jumps(model) &&
      model.with_starts_at_jumps(best.values()) == best.values())
    return best;
  return search_with_settled_starts(model, problem, std::move(best), control);
}

CalibrationResult search_with_settled_starts(const JointModel& model, CalibrationProblem& problem,
                                             CalibrationResult best, const RunControl& control) {
  constexpr int most_searches = 5;
  for (int count = 0; count < most_searches; ++count) {
    const std::vector<double> settled = model.with_settled_starts(best.values());
    if (left_of(model, settled) > left_of(model, best.values()) - least_gain_of_a_search) break;
    best = search_at(problem, settled, control);
  }
  return best;
}

}  // namespace rebound
