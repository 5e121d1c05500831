#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_of_balls.hpp"

#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/inference/calibration/effect_unknowns.hpp"
#include "comparisons/inference/calibration/search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
using Sums = BesideFittedNumbers::Sums;

std::vector<FirstOrderGain> FirstOrderOfBalls::gains(const std::vector<EffectChoice>& effects,
                                                     const RunControl& control) const {
  const auto sums = fit_each<Sums>(effects.size(), control, [&](std::size_t k) {
    Sums of_all;
    for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
      const auto& [fitted, around] = balls_[ball];
      if (!around) continue;
      const auto choices = effects_of_ball({effects[k]}, ball);
      if (with_effects(fitted, choices).material != fitted.material)
        throw Error(ExitCode::solver_failed, "this effect asks for another kind of ball");
      of_all += around->sums_of(choices);
    }
    return of_all;
  });
  std::vector<FirstOrderGain> gains(effects.size());
  for (std::size_t k = 0; k < effects.size(); ++k)
    if (sums[k])
      gains[k] = std::isfinite(find_effect(effects[k].name).card.null)
                     ? sums[k]->gain()
                     : sums[k]->gain_as_it_stands();
  return gains;
}

FirstOrderOfBalls::Fault FirstOrderOfBalls::searched(const EffectChoice& start,
                                                     const RunControl& control) const {
  CalibrationProblem problem;
  const EffectUnknowns numbers({start}, true, problem.parameters);
  problem.residuals = [&](const std::vector<double>& x) { return left_with(numbers.at(x)); };
  problem.noise = NoiseKnowledge::known;
  const CalibrationResult found = calibrate(problem, control);
  return {.choice = numbers.at(found.values()).front(),
          .gain = 2.0 * (half_square(left_with({})) - found.cost_after)};
}

std::vector<double> FirstOrderOfBalls::left_with(const std::vector<EffectChoice>& faults) const {
  std::vector<double> rows;
  for (const Ball& ball : balls_) {
    if (!ball.around) continue;
    const Eigen::VectorXd left = ball.around->left_with(faults);
    rows.insert(rows.end(), left.begin(), left.end());
  }
  return rows;
}

}  // namespace rebound
