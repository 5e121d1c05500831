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

/// Where one ball has an unknown when it is alone, and among all balls.
struct SameUnknown {
  std::size_t alone, among_all;
};

/// All unknowns of a ball but those of the effect. Its shots are next to each other.
std::vector<SameUnknown> unknowns_of(std::size_t ball, const JointModel& alone,
                                     const JointModel& all, const Observations& seen) {
  std::vector<SameUnknown> same;
  const auto& own = alone.unknowns_of_ball(0);
  for (std::size_t k = 0; k < own.size(); ++k)
    same.push_back({own[k], all.unknowns_of_ball(ball)[k]});
  std::size_t own_shot = 0;
  for (std::size_t shot = 0; shot < seen.shots.size(); ++shot) {
    if (seen.shots[shot].ball != ball) continue;
    const auto of_one = alone.nuisances_of(own_shot++);
    for (std::size_t k = 0; k < of_one.size(); ++k)
      same.push_back({of_one[k].unknown, all.nuisances_of(shot)[k].unknown});
  }
  return same;
}

/// A fit that has not been searched for, with an effect at its start.
HypothesisFit unsearched(const Observations& seen, const std::shared_ptr<const FemBelief>& fem,
                         const EffectChoice& start) {
  HypothesisFit fit;
  fit.effects = {start};
  fit.hypothesis = {.believed = {}, .fem = fem, .effects = fit.effects};
  fit.model = std::make_shared<const JointModel>(seen, fit.hypothesis);
  fit.values = fit.model->start();
  return fit;
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
  sizes.reserve(choices.size());
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
  HypothesisFit near = unsearched(balls.seen, balls.fem, start);
  for (std::size_t ball = 0; ball < apart.size(); ++ball)
    for (const auto& [alone, among_all] :
         unknowns_of(ball, *apart[ball]->model, *near.model, balls.seen))
      near.values[among_all] = apart[ball]->values[alone];
  return fit_further(balls.seen, near, control);
}

HypothesisFit fit_alone(const FitsOfEffects& own, const HypothesisFit& all, std::size_t ball,
                        const BallsTogether& balls, const RunControl& control) {
  const EffectChoice start = effects_of_ball(all.effects, ball).back();
  HypothesisFit near = unsearched(*own.seen, own.believed.hypothesis.fem, start);
  for (const auto& [alone, among_all] : unknowns_of(ball, *near.model, *all.model, balls.seen))
    near.values[alone] = all.values[among_all];
  return fit_further(*own.seen, near, control);
}

}  // namespace rebound
