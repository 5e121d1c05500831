#include "comparisons/diagnosis/joint_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/instrument/reported_force.hpp"
#include "comparisons/instrument/ring_down.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

constexpr LumpedControls impact_controls{.relative_tolerance = 1e-8, .samples = 401};
constexpr double law_reach = 3.0;         // a factor of twenty either way
constexpr double nothing = 0.01;          // of the prior scale
constexpr double parameter_reach = 100.0; // a factor either way of a fitted parameter's default
constexpr std::size_t most_kept = 256;    // impacts a shot
constexpr double first_rise = 0.05;       // of the peak: finds the start of contact

/// Instant at which a force first rises above a share of its peak.
double rise_time(const std::vector<double>& time, const std::vector<double>& force) {
  const double level = first_rise * *std::max_element(force.begin(), force.end());
  std::size_t i = 0;
  while (force[i] < level) ++i;
  return time[i];
}

}  // namespace

JointModel::JointModel(const Observations& seen, const Hypothesis& hypothesis)
    : seen_(seen), hypothesis_(hypothesis), impacts_(seen.shots.size()) {
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    const ObservedShot& shot = seen.shots[i];
    if (shot.history)
      for (const double time : shot.history->time) rows_.push_back({i, ObservedQuantity::force, time});
    for (const ObservedScalar& scalar : shot.scalars) rows_.push_back({i, scalar.what, 0.0});
  }
  add_law_factors();
  add_effects();
  add_nuisances();
  estimate_starts();
}

std::size_t JointModel::add(const CalibrationParameter& unknown, double prior) {
  unknowns_.push_back(unknown);
  priors_.push_back(prior);
  return unknowns_.size() - 1;
}

void JointModel::add_law_factors() {
  const LawCard& card = find_law(hypothesis_.believed.law);
  const bool by_formula = !hypothesis_.believed.damping_formula.empty();
  for (const ParameterCard& parameter : card.parameters)
    if (!parameter.default_value && !(by_formula && parameter.name == card.damping_parameter))
      law_parameters_.push_back(parameter.name);
  for (const ObservedBall& ball : seen_.balls) {
    auto& factors = law_factors_.emplace_back();
    for (const auto& name : law_parameters_)
      factors.push_back(add({.name = seen_.balls.size() > 1 ? name + " of " + ball.name : name,
                             .unit = "ln of factor", .start = 0.0, .lowest = -law_reach,
                             .highest = law_reach, .scale = 1.0}, 0.0));
  }
}

void JointModel::add_effects() {
  for (const EffectChoice& choice : hypothesis_.effects) {
    const EffectCard& card = find_effect(choice.name).card;
    auto& own = effect_unknowns_.emplace_back();
    if (card.is_switch) continue;
    // A plate or a branch next to nothing is stiff and cannot be told from
    // nothing: searches keep off a one-sided null.
    const double least = card.null <= card.lowest ? card.null + nothing * card.prior_scale : card.lowest;
    own.push_back(add({.name = card.name, .unit = "SI", .start = std::max(choice.size, least),
                       .lowest = least, .highest = card.highest, .scale = card.prior_scale}, 0.0));
    for (const EffectParameterCard& parameter : card.parameters) {
      if (!parameter.fitted) continue;
      const auto given = choice.parameters.find(parameter.name);
      const double start = given != choice.parameters.end() ? given->second : parameter.default_value;
      const double lowest = std::max(parameter.lowest, parameter.default_value / parameter_reach);
      const double highest = std::min(parameter.highest, parameter.default_value * parameter_reach);
      own.push_back(add({.name = card.name + " " + parameter.name, .unit = "ln SI",
                         .start = std::log(std::clamp(start, lowest, highest)),
                         .lowest = std::log(lowest), .highest = std::log(highest), .scale = 1.0},
                        0.0));
    }
  }
}

void JointModel::add_nuisances() {
  constexpr double anything = 1e3;  // a bound that is none: priors hold nuisances
  const auto nuisance = [&](const std::string& name, const std::string& unit, double prior) {
    const double scale = prior;
    return add({.name = name, .unit = unit, .start = 0.0, .lowest = -anything * scale,
                .highest = anything * scale, .scale = scale}, prior);
  };
  double noise = 0.0;
  for (const auto& shot : seen_.shots)
    if (shot.history) noise = std::max(noise, shot.history->noise);
  if (noise > 0.0) {
    if (seen_.gain_uncertainty > 0.0) gain_ = nuisance("force gain", "1", seen_.gain_uncertainty);
    baseline_ = nuisance("force baseline", "N", noise);
  }
  for (const auto& ball : seen_.balls)
    mass_.push_back(ball.mass_uncertainty > 0.0
                        ? nuisance("mass error of " + ball.name, "1",
                                   ball.mass_uncertainty / ball.sphere.mass)
                        : none);
  for (const auto& shot : seen_.shots) {
    auto& own = shots_.emplace_back();
    if (shot.speed_uncertainty > 0.0)
      own.speed = nuisance("speed error, " + shot.label, "1", shot.speed_uncertainty / shot.speed);
    if (shot.history) {
      const double span = shot.history->time.back() - shot.history->time.front();
      own.start = add({.name = "start, " + shot.label, .unit = "s", .start = 0.0,
                       .lowest = shot.history->time.front() - span,
                       .highest = shot.history->time.back(), .scale = 1e-3 * span}, 0.0);
      shot_nuisances_.push_back(own.start);
    }
    if (own.speed != none) shot_nuisances_.push_back(own.speed);
  }
}

/// Where data and model first rise to the same share of their peaks.
void JointModel::estimate_starts() {
  std::vector<double> values = start();
  for (std::size_t i = 0; i < shots_.size(); ++i) {
    if (shots_[i].start == none) continue;
    CalibrationParameter& unknown = unknowns_[shots_[i].start];
    unknown.start = seen_.shots[i].history->time.front();  // anywhere; the impact does not ask
    values[shots_[i].start] = unknown.start;
    const Trace& model = impact(values, i).trace;
    const ForceHistory& data = *seen_.shots[i].history;
    unknown.start = std::clamp(rise_time(data.time, data.force) - rise_time(model.time, model.force),
                               unknown.lowest, unknown.highest);
  }
}

std::vector<double> JointModel::start() const {
  std::vector<double> values;
  for (const auto& unknown : unknowns_) values.push_back(unknown.start);
  return values;
}

std::vector<EffectChoice> JointModel::effects_at(const std::vector<double>& values) const {
  std::vector<EffectChoice> effects = hypothesis_.effects;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const auto& own = effect_unknowns_[k];
    if (own.empty()) continue;
    effects[k].size = values[own[0]];
    std::size_t next = 1;
    for (const auto& parameter : find_effect(effects[k].name).card.parameters)
      if (parameter.fitted)
        effects[k].parameters[parameter.name] =
            std::clamp(std::exp(values[own[next++]]), parameter.lowest, parameter.highest);
  }
  return effects;
}

LumpedModel JointModel::believed_at(const std::vector<double>& values, std::size_t ball) const {
  LumpedModel model = hypothesis_.believed;
  for (std::size_t p = 0; p < law_parameters_.size(); ++p) {
    const double factor = std::exp(values[law_factors_[ball][p]]);
    const auto scale = [&](ParameterValues& numbers) {
      if (const auto found = numbers.find(law_parameters_[p]); found != numbers.end())
        found->second *= factor;
    };
    scale(model.parameters);
    for (auto& entry : model.at_speed) scale(entry.parameters);
  }
  return model;
}

MeasurementChain JointModel::chain_at(const std::vector<double>& values, std::size_t shot) const {
  MeasurementChain chain;
  chain.contact_threshold = seen_.shots[shot].contact_threshold;
  apply_effects(effects_at(values), chain);
  chain.force_gain += value(values, gain_);
  chain.force_baseline += value(values, baseline_);
  chain.mass_error += value(values, mass_[seen_.shots[shot].ball]);
  chain.speed_error += value(values, shots_[shot].speed);
  return chain;
}

LumpedProblem JointModel::problem_at(const std::vector<double>& values, std::size_t shot) const {
  const ObservedShot& observed = seen_.shots[shot];
  const MeasurementChain chain = chain_at(values, shot);
  LumpedProblem problem{.sphere = seen_.balls[observed.ball].sphere,
                        .impact = {.speed = observed.speed},
                        .model = believed_at(values, observed.ball),
                        .controls = impact_controls};
  problem.sphere.mass /= 1.0 + chain.mass_error;
  if (!problem.model.damping_formula.empty() && observed.restitution)
    problem.model.restitution = observed.restitution;
  apply_effects(physical_effects(effects_at(values)), problem);
  // Numbers fitted at a nominal speed belong to the shot, whatever its true speed.
  problem.model.parameters = resolve_parameters(problem.model, problem.impact, problem.sphere);
  problem.model.at_speed.clear();
  problem.model.restitution.reset();
  problem.model.damping_formula.clear();
  problem.model.exact_damping_share = 0.0;
  problem.impact.speed /= 1.0 + chain.speed_error;
  return problem;
}

const LumpedResult& JointModel::impact(const std::vector<double>& values, std::size_t shot) const {
  // The impact itself does not depend on gain, baseline or the clock.
  std::vector<double> key;
  for (const std::size_t factor : law_factors_[seen_.shots[shot].ball]) key.push_back(values[factor]);
  for (const auto& own : effect_unknowns_)
    for (const std::size_t index : own) key.push_back(values[index]);
  key.push_back(value(values, mass_[seen_.shots[shot].ball]));
  key.push_back(value(values, shots_[shot].speed));
  auto& kept = impacts_[shot];
  if (const auto found = kept.find(key); found != kept.end()) return found->second;
  if (kept.size() >= most_kept) kept.clear();
  return kept.emplace(std::move(key), simulate_fast(problem_at(values, shot))).first->second;
}

double JointModel::first_touch(const std::vector<double>& values, std::size_t shot) const {
  return value(values, shots_[shot].start);
}

std::vector<double> JointModel::force_at(const std::vector<double>& values, std::size_t shot,
                                         const std::vector<double>& time) const {
  const LumpedResult& result = impact(values, shot);
  MeasurementChain chain = chain_at(values, shot);
  chain.trigger_shift += first_touch(values, shot);
  const Plate plate = problem_at(values, shot).model.mechanisms.plate;
  Trace force = with_ring_down(result.trace, plate,
                               time.back() - chain.trigger_shift - result.trace.time.back());
  if (hypothesis_.tier_gap)
    force = hypothesis_.tier_gap->added_to(force, result.scalars, seen_.shots[shot].ball,
                                           seen_.shots[shot].speed);
  return reported_force(force, chain, time);
}

double JointModel::scalar_at(const std::vector<double>& values, std::size_t shot,
                             ObservedQuantity what) const {
  const LumpedResult& result = impact(values, shot);
  const MeasurementChain chain = chain_at(values, shot);
  switch (what) {
    case ObservedQuantity::restitution: return result.scalars.restitution;
    case ObservedQuantity::contact_time:
      return chain.contact_threshold > 0.0 ? time_above(result.trace, chain.contact_threshold)
                                           : result.scalars.contact_time;
    case ObservedQuantity::peak_force:
      return (1.0 + chain.force_gain) * result.scalars.peak_force + chain.force_baseline;
    case ObservedQuantity::peak_deflection: return result.scalars.peak_deflection;
    case ObservedQuantity::mean_deflection: return result.scalars.mean_deflection;
    case ObservedQuantity::force: break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> JointModel::residuals(const std::vector<double>& values) const {
  std::vector<double> residuals;
  residuals.reserve(rows_.size() + priors_.size());
  for (std::size_t i = 0; i < seen_.shots.size(); ++i) {
    const ObservedShot& shot = seen_.shots[i];
    if (shot.history) {
      const auto r = whitened(*shot.history, force_at(values, i, shot.history->time));
      residuals.insert(residuals.end(), r.begin(), r.end());
    }
    for (const ObservedScalar& scalar : shot.scalars)
      residuals.push_back((scalar_at(values, i, scalar.what) - scalar.value) / scalar.uncertainty);
  }
  for (std::size_t k = 0; k < priors_.size(); ++k)
    if (priors_[k] > 0.0) residuals.push_back(values[k] / priors_[k]);
  return residuals;
}

}  // namespace rebound
