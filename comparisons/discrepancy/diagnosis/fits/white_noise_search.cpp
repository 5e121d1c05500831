#include "comparisons/discrepancy/diagnosis/fits/white_noise_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_search.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Does the effect act at first touch, where a law of Hertz's kind has no force yet?
bool is_at_first_touch(const EffectChoice& effect) {
  const EffectFamily family = find_effect(effect.name).card.family;
  return family == EffectFamily::rate || family == EffectFamily::surface;
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

/// The same shots, as if white noise of this share of the variance were beside theirs.
Observations whitened(Observations seen, double share) {
  for (MeasuredImpact& shot : seen.shots) {
    std::vector<double>& colour = shot.noise.autocorrelation;
    if (share >= 1.0) colour.clear();
    for (double& one : colour) one *= 1.0 - share;
  }
  return seen;
}

/// The least share of its variance that the past of a shot's noise leaves open.
double least_innovation(const Observations& seen) {
  double least = 1.0;
  for (const MeasuredImpact& shot : seen.shots)
    if (const std::vector<double>& colour = shot.noise.autocorrelation; !colour.empty())
      least = std::min(least, linear_predictors(colour).variance.back());
  return least;
}

/// Searches the hypothesis of `problem` under other noise, from where its unknowns start, and lets
/// them start where that has ended; says how much is left per reading.
double start_where_it_fits(const Observations& seen, const Hypothesis& hypothesis,
                           CalibrationProblem& problem, const RunControl& control) {
  const JointModel model(seen, hypothesis);
  CalibrationProblem first = model.problem();
  first.controls = problem.controls;
  copy_starts(problem, first);
  const CalibrationResult found = is_correlated(seen) ? search_from_both(model, first, control)
                                                      : search_joint_model(model, first, control);
  start_at(found.values(), first);
  copy_starts(first, problem);
  return 2.0 * found.cost_after /
         static_cast<double>(std::max<std::size_t>(1, model.rows().size()));
}

}  // namespace

bool acts_at_first_touch_alone(const Hypothesis& hypothesis) {
  return !hypothesis.effects.empty() &&
         std::all_of(hypothesis.effects.begin(), hypothesis.effects.end(), is_at_first_touch);
}

std::vector<Observations> with_white_noise_beside(const Observations& seen,
                                                  const Hypothesis& hypothesis) {
  if (hypothesis.fem || !is_correlated(seen)) return {};
  const double innovation = least_innovation(seen);
  std::vector<Observations> stages;
  for (const double share : {1.0, 0.1, 0.01})
    if (share > innovation || share == 1.0) stages.push_back(whitened(seen, share));
  return stages;
}

CalibrationResult search_from_both(const JointModel& model, CalibrationProblem problem,
                                   const RunControl& control) {
  std::vector<double> start;
  for (const CalibrationParameter& unknown : problem.parameters) start.push_back(unknown.start);
  CalibrationProblem settled = problem;
  CalibrationResult best = search_joint_model(model, problem, control);
  start_at(model.with_settled_starts(std::move(start)), settled);
  CalibrationResult other =
      search_with_settled_starts(model, settled, calibrate(settled, control), control);
  return other.cost_after < best.cost_after ? other : best;
}

std::optional<CalibrationResult> search_by_stages(const std::vector<Observations>& stages,
                                                  const JointModel& model,
                                                  CalibrationProblem problem,
                                                  const RunControl& control) try {
  if (stages.empty()) return std::nullopt;
  constexpr double hopeless = 1e3;  // no start of a record makes such a gap
  for (const Observations& stage : stages)
    if (start_where_it_fits(stage, model.hypothesis(), problem, control) > hopeless)
      return std::nullopt;
  return search_from_both(model, std::move(problem), control);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  return std::nullopt;
}

}  // namespace rebound
