#include "comparisons/discrepancy/diagnosis/fits/white_noise_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Does one of its effects act at first touch, where a law of Hertz's kind has no force yet?
bool acts_at_first_touch(const Hypothesis& hypothesis) {
  return std::any_of(hypothesis.effects.begin(), hypothesis.effects.end(),
                     [](const EffectChoice& one) {
                       const EffectFamily family = find_effect(one.name).card.family;
                       return family == EffectFamily::rate || family == EffectFamily::surface;
                     });
}

bool is_correlated(const Observations& seen) {
  return std::any_of(seen.shots.begin(), seen.shots.end(), [](const MeasuredImpact& shot) {
    return !shot.noise.autocorrelation.empty();
  });
}

/// Of unknowns of the same name: a zero that wanders is one of correlated noise alone.
void copy_starts(const CalibrationProblem& from, CalibrationProblem& to) {
  for (CalibrationParameter& unknown : to.parameters)
    for (const CalibrationParameter& other : from.parameters)
      if (unknown.name == other.name) unknown.start = other.start;
}

}  // namespace

std::optional<CalibrationResult> search_by_white_noise(const Observations& seen,
                                                       const JointModel& model,
                                                       CalibrationProblem problem,
                                                       const RunControl& control) try {
  if (model.fem() || !acts_at_first_touch(model.hypothesis()) || !is_correlated(seen))
    return std::nullopt;
  Observations white = seen;
  for (MeasuredImpact& shot : white.shots) shot.noise.autocorrelation.clear();
  const JointModel as_white(white, model.hypothesis());
  CalibrationProblem first = as_white.problem();
  first.controls = problem.controls;
  copy_starts(problem, first);
  start_at(search_joint_model(as_white, first, control).values(), first);
  copy_starts(first, problem);
  std::vector<double> near;
  for (const CalibrationParameter& unknown : problem.parameters) near.push_back(unknown.start);
  start_at(model.with_settled_starts(std::move(near)), problem);
  return search_with_settled_starts(model, problem, calibrate(problem, control), control);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  return std::nullopt;
}

}  // namespace rebound
