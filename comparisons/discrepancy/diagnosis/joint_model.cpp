#include "comparisons/discrepancy/diagnosis/joint_model.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/repeated_shots.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {
namespace {

constexpr LumpedControls impact_controls{.relative_tolerance = 1e-7, .samples = 201};
constexpr std::size_t most_kept = 256;  // impacts a shot
constexpr double first_rise = 0.3;      // of the peak: above the noise, finds the start of contact

/// Instant at which a force first rises above a share of its peak.
double rise_time(const std::vector<double>& time, const std::vector<double>& force) {
  const double level = first_rise * *std::max_element(force.begin(), force.end());
  std::size_t i = 0;
  while (force[i] < level) ++i;
  return time[i];
}

}  // namespace

JointModel::JointModel(const Observations& seen, const Hypothesis& hypothesis)
    : JointModel(seen, hypothesis, {}) {
  estimate_starts();
}

JointModel::JointModel(const JointModel& fitted, const std::vector<double>& values,
                       const Hypothesis& hypothesis)
    : JointModel(fitted.seen_, hypothesis, {}) {
  for (const auto& [shot, place] : starts_)
    unknowns_[place].start = values[fitted.starts_.at(shot)];
  if (!is_measurement(hypothesis.effects.back().name)) return;
  for (std::size_t i = 0; i < impacts_.size(); ++i) {
    fitted.impact(values, i);
    const auto key = fitted.impact_key(values, i);
    impacts_[i].emplace(key, fitted.impacts_[i].at(key));
  }
}

JointModel::JointModel(const Observations& seen, const Hypothesis& hypothesis, Unstarted)
    : seen_(seen),
      hypothesis_(hypothesis),
      law_(hypothesis.believed, seen.balls, unknowns_),
      effects_(hypothesis.effects, unknowns_),
      nuisances_(seen.shots.size()),
      blocks_(seen.shots.size()),
      impacts_(seen.shots.size()),
      first_of_group_(shots_that_share(seen, hypothesis.believed)),
      pairs_(seen.shots.size()) {
  add_rows();
  add_slow_factors();
  nuisances_.add_stated(seen, unknowns_);
  add_shots();
}

void JointModel::add_shots() {
  for (std::size_t i = 0; i < seen_.shots.size(); ++i) {
    const std::size_t before = nuisances_.of_shots().size();
    nuisances_.add_stated_of_shot(seen_, i, unknowns_);
    if (seen_.shots[i].has_history()) shot_nuisances_.push_back(add_start(i));
    for (std::size_t k = before; k < nuisances_.of_shots().size(); ++k)
      shot_nuisances_.push_back(nuisances_.of_shots()[k]);
  }
}

std::size_t JointModel::add_start(std::size_t shot) {
  const std::vector<double>& time = seen_.shots[shot].trace.time;
  const double span = time.back() - time.front();
  return starts_[shot] = nuisances_.add(find_nuisance("trigger"),
                                        {.name = "start, " + seen_.shots[shot].label,
                                         .unit = "s",
                                         .start = 0.0,
                                         .lowest = time.front() - span,
                                         .highest = time.back(),
                                         .scale = 1e-3 * span},
                                        {shot}, unknowns_);
}

void JointModel::estimate_starts() {
  std::vector<double> values = start();
  for (const auto& [shot, place] : starts_) {
    CalibrationParameter& unknown = unknowns_[place];
    const Trace& data = seen_.shots[shot].trace;
    unknown.start = data.time.front();  // anywhere; the impact does not ask
    values[place] = unknown.start;
    const Trace& model = impact(values, shot).trace;
    unknown.start =
        std::clamp(rise_time(data.time, data.force) - rise_time(model.time, model.force),
                   unknown.lowest, unknown.highest);
  }
}

std::vector<double> JointModel::start() const {
  std::vector<double> values;
  for (const auto& unknown : unknowns_) values.push_back(unknown.start);
  return values;
}

LumpedProblem JointModel::problem_at(const std::vector<double>& values, std::size_t shot) const {
  const MeasuredImpact& observed = seen_.shots[shot];
  const MeasurementChain chain = chain_at(values, shot);
  LumpedProblem problem{.sphere = observed.sphere,
                        .impact = observed.impact,
                        .model = believed_at(values, observed.ball),
                        .controls = impact_controls};
  problem.sphere.mass /= 1.0 + chain.mass_error;
  if (!problem.model.damping_formula.empty() && observed.restitution.value)
    problem.model.restitution = observed.restitution.value;
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
  return kept_impact(values, shot).result;
}

const JointModel::KeptImpact& JointModel::kept_impact(const std::vector<double>& values,
                                                      std::size_t shot) const {
  std::vector<double> key = impact_key(values, shot);
  auto& kept = impacts_[shot];
  if (const auto found = kept.find(key); found != kept.end()) return *found->second;
  if (kept.size() >= most_kept) kept.clear();
  auto run = std::make_shared<const KeptImpact>(run_impact(values, shot));
  return *kept.emplace(std::move(key), std::move(run)).first->second;
}

JointModel::KeptImpact JointModel::run_impact(const std::vector<double>& values,
                                              std::size_t shot) const {
  constexpr double farthest = 3.0;  // times the distance of the two impacts
  const std::size_t first = first_of_group_[shot];
  const bool alone = std::count(first_of_group_.begin(), first_of_group_.end(), first) == 1;
  const double speed = seen_.shots[shot].impact.speed / (1.0 + chain_at(values, shot).speed_error);
  const double share = (speed / seen_.shots[first].impact.speed - 1.0) / faster;
  if (!alone && std::abs(share) <= farthest) {
    const SpeedPair& pair = speed_pair(values, first);
    return {between(pair.nominal.result, pair.above, share), pair.nominal.plate};
  }
  const LumpedProblem problem = problem_at(values, shot);
  return {simulate_fast(problem), problem.model.mechanisms.plate};
}

const JointModel::SpeedPair& JointModel::speed_pair(const std::vector<double>& values,
                                                    std::size_t first) const {
  std::vector<double> key = impact_key(values, first);
  key.pop_back();  // the speed error: both speeds are the group's own
  auto& kept = pairs_[first];
  if (const auto found = kept.find(key); found != kept.end()) return found->second;
  if (kept.size() >= most_kept) kept.clear();
  LumpedProblem problem = problem_at(values, first);
  problem.impact.speed = seen_.shots[first].impact.speed;
  SpeedPair pair{{simulate_fast(problem), problem.model.mechanisms.plate}, {}};
  problem.impact.speed *= 1.0 + faster;
  pair.above = simulate_fast(problem);
  return kept.emplace(std::move(key), std::move(pair)).first->second;
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
  for (const std::size_t factor : law_.places(seen_.shots[shot].ball))
    key.push_back(values[factor]);
  for (std::size_t k = 0; k < effects_.count(); ++k)
    if (!is_measurement(hypothesis_.effects[k].name))
      for (const std::size_t index : effects_.places(k)) key.push_back(values[index]);
  const MeasurementChain chain = chain_at(values, shot);
  key.push_back(chain.mass_error);
  key.push_back(chain.speed_error);
  return key;
}

}  // namespace rebound
