// The impacts of a joint model, of either tier, run once each: the third part of JointModel.
#include <algorithm>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/discrepancy/diagnosis/observations/repeated_shots.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr LumpedControls impact_controls{
    .relative_tolerance = 1e-7, .samples = 201, .finer_ends = true, .most_steps = 4000};
constexpr int samples_of_two_masses = 801;  // their faster swing is a thirtieth of a contact
constexpr std::size_t most_kept = 256;      // impacts a shot

/// No impact where numbers that a search tries are outside what a problem may have.
ModelledImpact run_lumped(const LumpedProblem& problem) try {
  LumpedResult result = simulate_fast(problem);
  return {.trace = std::move(result.trace),
          .scalars = result.scalars,
          .plate = problem.model.mechanisms.plate};
} catch (const Error& error) {
  if (error.code() != ExitCode::bad_input) throw;
  throw Error(ExitCode::solver_failed, error.what());
}

}  // namespace

LumpedProblem JointModel::problem_at(const std::vector<double>& values, std::size_t shot) const {
  try {
    return lumped_problem(values, shot);
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input) throw;
    throw Error(ExitCode::solver_failed, error.what());  // numbers a search tries, no file's
  }
}

LumpedProblem JointModel::lumped_problem(const std::vector<double>& values,
                                         std::size_t shot) const {
  const MeasuredImpact& observed = seen_.shots[shot];
  const MeasurementChain chain = chain_at(values, shot);
  LumpedProblem problem{.sphere = observed.sphere,
                        .impact = observed.impact,
                        .model = believed_at(values, observed.ball),
                        .controls = impact_controls};
  problem.sphere.mass /= 1.0 + chain.mass_error;
  if (!problem.model.damping_formula.empty() && observed.restitution.value)
    problem.model.restitution = observed.restitution.value;
  apply_effects(physical_effects(effects_of_shot(values, shot)), problem);
  const Plate& plate = problem.model.mechanisms.plate;
  if (plate.moves() && plate.frame.moves()) problem.controls.samples = samples_of_two_masses;
  // Numbers fitted at a nominal speed belong to the shot, whatever its true speed.
  problem.model.parameters = resolve_parameters(problem.model, problem.impact, problem.sphere);
  problem.model.at_speed.clear();
  problem.model.restitution.reset();
  problem.model.damping_formula.clear();
  problem.model.exact_damping_share = 0.0;
  problem.impact.speed /= 1.0 + chain.speed_error;
  return problem;
}

const JointModel::KeptImpact& JointModel::kept_impact(const std::vector<double>& values,
                                                      std::size_t shot) const {
  std::vector<double> key = impact_key(values, shot);
  auto& kept = impacts_[shot];
  if (const auto found = kept.find(key); found != kept.end()) return found->second;
  if (kept.size() >= most_kept) kept.clear();
  auto run = std::make_shared<const ModelledImpact>(run_impact(values, shot));
  return kept.emplace(std::move(key), std::move(run)).first->second;
}

void JointModel::run_fem_ahead(const std::vector<double>& values) const {
  in_parallel(seen_.shots.size(), [&](std::size_t first) {
    for (std::size_t shot = first; shot < seen_.shots.size(); ++shot)
      if (first_of_group_[shot] == first) kept_impact(values, shot);
  });
}

ModelledImpact JointModel::run_at(const std::vector<double>& values, std::size_t shot,
                                  double speed) const {
  if (fem()) return run_in_fem(values, shot, speed);
  LumpedProblem problem = problem_at(values, shot);
  problem.impact.speed = speed;
  return run_lumped(problem);
}

ModelledImpact JointModel::run_in_fem(const std::vector<double>& values, std::size_t shot,
                                      double speed) const {
  Impact impact = seen_.shots[shot].impact;
  impact.speed = speed;
  const std::size_t ball = seen_.shots[shot].ball;
  return fem()->run(ball, impact, material_at(values, ball),
                    physical_effects(effects_of_shot(values, shot)));
}

ModelledImpact JointModel::run_impact(const std::vector<double>& values, std::size_t shot) const {
  constexpr double farthest = 3.0;  // times the distance of the two impacts
  const std::size_t first = first_of_group_[shot];
  const bool alone = std::count(first_of_group_.begin(), first_of_group_.end(), first) == 1;
  const double speed = seen_.shots[shot].impact.speed / (1.0 + chain_at(values, shot).speed_error);
  const double share = (speed / seen_.shots[first].impact.speed - 1.0) / faster;
  // In FE a small change of speed is a line between two impacts always: nodes that touch one by
  // one are noise beside it.
  const bool on_the_line = (!alone || fem()) && std::abs(share) <= farthest;
  ModelledImpact impact = on_the_line ? between(speed_pair(values, first).nominal,
                                                speed_pair(values, first).above, share)
                                      : run_at(values, shot, speed);
  if (!fem()) return impact;
  // A heavier ball of a stiffer material moves alike, and the modulus is free: an error of the mass
  // scales forces and needs no impact of its own.
  return times_as_heavy(std::move(impact), 1.0 / (1.0 + chain_at(values, shot).mass_error));
}

const JointModel::SpeedPair& JointModel::speed_pair(const std::vector<double>& values,
                                                    std::size_t first) const {
  std::vector<double> key = impact_key(values, first);
  key.pop_back();             // the speed error: both speeds are the group's own
  if (fem()) key.pop_back();  // the mass error: see run_impact()
  auto& kept = pairs_[first];
  if (const auto found = kept.find(key); found != kept.end()) return found->second;
  if (kept.size() >= most_kept) kept.clear();
  const double speed = seen_.shots[first].impact.speed;
  SpeedPair pair{run_at(values, first, speed), run_at(values, first, (1.0 + faster) * speed)};
  return kept.emplace(std::move(key), std::move(pair)).first->second;
}

ModelledImpact JointModel::planned_impact(const std::vector<double>& values, std::size_t like,
                                          double speed_factor, double mass_factor) const {
  const MeasuredImpact& shot = seen_.shots[like];
  const double speed =
      speed_factor * shot.impact.speed / (1.0 + chain_at(values, like).speed_error);
  if (fem()) {
    Impact impact = shot.impact;
    impact.speed = speed;
    Material material = material_at(values, shot.ball);
    material.youngs_modulus /= mass_factor;
    return times_as_heavy(
        fem()->run(shot.ball, impact, material, physical_effects(effects_of_shot(values, like))),
        mass_factor);
  }
  LumpedProblem problem = problem_at(values, like);
  problem.impact.speed = speed;
  problem.sphere.mass *= mass_factor;
  return run_lumped(problem);
}

void JointModel::forget_impacts() const {
  for (auto& kept : impacts_) kept.clear();
  for (auto& kept : pairs_) kept.clear();
  for (auto& kept : blocks_) kept.clear();
}

std::vector<double> JointModel::impact_key(const std::vector<double>& values,
                                           std::size_t shot) const {
  // The impact itself does not depend on gain, baseline or the clock.
  std::vector<double> key;
  for (const std::size_t factor : unknowns_of_ball(seen_.shots[shot].ball))
    key.push_back(values[factor]);
  for (std::size_t k = 0; k < effects_.count(); ++k)
    if (!is_measurement(hypothesis_.effects[k].name))
      for (const std::size_t index : effects_.places_of_ball(k, seen_.shots[shot].ball))
        key.push_back(values[index]);
  const MeasurementChain chain = chain_at(values, shot);
  key.push_back(chain.mass_error);
  key.push_back(chain.speed_error);
  return key;
}

}  // namespace rebound
