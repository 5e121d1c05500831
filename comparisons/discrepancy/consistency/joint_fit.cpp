#include "comparisons/discrepancy/consistency/joint_fit.hpp"

#include <cmath>

#include "comparisons/discrepancy/consistency/joint_observations.hpp"

namespace rebound {
namespace {

double mean_of(const std::vector<double>& values, bool of_logarithms) {
  double sum = 0.0;
  for (const double value : values) sum += of_logarithms ? std::log(value) : value;
  const double mean = sum / static_cast<double>(values.size());
  return of_logarithms ? std::exp(mean) : mean;
}

/// What one ball's fit has found of everything but the effect, put where all balls have it.
void carry_numbers(const HypothesisFit& fit, std::size_t ball, std::size_t first_shot,
                   std::size_t shots, HypothesisFit& all) {
  const auto& from = fit.model->unknowns_of_ball(0);
  const auto& to = all.model->unknowns_of_ball(ball);
  for (std::size_t k = 0; k < from.size(); ++k) all.values[to[k]] = fit.values[from[k]];
  for (std::size_t shot = 0; shot < shots; ++shot) {
    const auto of_one = fit.model->nuisances_of(shot);
    const auto of_all = all.model->nuisances_of(first_shot + shot);
    for (std::size_t k = 0; k < of_one.size(); ++k)
      all.values[of_all[k].unknown] = fit.values[of_one[k].unknown];
  }
}

}  // namespace

BallsTogether put_together(const std::vector<const FitsOfEffects*>& apart) {
  std::vector<const Observations*> seen, unseen;
  std::vector<std::shared_ptr<const FemBelief>> fem;
  for (const FitsOfEffects* ball : apart) {
    seen.push_back(ball->seen.get());
    unseen.push_back(&ball->unseen);
    fem.push_back(ball->believed.hypothesis.fem);
  }
  return {.seen = balls_together(seen),
          .unseen = balls_together(unseen),
          .fem = std::make_shared<const FemBelief>(FemBelief::together(std::move(fem)))};
}

EffectChoice absent(const std::string& name) {
  return {.name = name, .size = find_effect(name).card.null, .parameters = {}};
}

EffectChoice middle_of(const std::vector<EffectChoice>& choices) {
  EffectChoice middle = choices.front();
  const EffectCard& card = find_effect(middle.name).card;
  std::vector<double> sizes;
  for (const EffectChoice& one : choices) sizes.push_back(one.size);
  middle.size = mean_of(sizes, has_logarithmic_size(card));
  for (const EffectParameterCard& parameter : card.parameters) {
    if (!is_unknown(parameter, true, middle)) continue;
    std::vector<double> values;
    for (const EffectChoice& one : choices) {
      const auto given = one.parameters.find(parameter.name);
      values.push_back(given == one.parameters.end() ? parameter.default_value : given->second);
    }
    middle.parameters[parameter.name] =
        mean_of(values, parameter.kind == ParameterKind::logarithmic);
  }
  return middle;
}

HypothesisFit fit_together(const BallsTogether& balls,
                           const std::vector<const HypothesisFit*>& apart,
                           const EffectChoice& start, const RunControl& control) {
  HypothesisFit near;
  near.effects = {start};
  near.hypothesis = {.believed = {}, .fem = balls.fem, .effects = near.effects};
  near.model = std::make_shared<const JointModel>(balls.seen, near.hypothesis);
  near.values = near.model->start();
  std::size_t first = 0;
  for (std::size_t ball = 0; ball < apart.size(); ++ball) {
    std::size_t shots = 0;
    while (first + shots < balls.seen.shots.size() && balls.seen.shots[first + shots].ball == ball)
      ++shots;
    carry_numbers(*apart[ball], ball, first, shots, near);
    first += shots;
  }
  return fit_further(balls.seen, near, control);
}

}  // namespace rebound
