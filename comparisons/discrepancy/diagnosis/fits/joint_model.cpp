#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/discrepancy/diagnosis/observations/repeated_shots.hpp"

namespace rebound {
namespace {

std::variant<LawFactors, MaterialFactors> numbers_of(const Hypothesis& hypothesis,
                                                     const std::vector<Ball>& balls,
                                                     std::vector<CalibrationParameter>& unknowns) {
  if (hypothesis.fem) {
    std::vector<Material> materials;
    for (std::size_t ball = 0; ball < balls.size(); ++ball)
      materials.push_back(hypothesis.fem->material_of(ball));
    return MaterialFactors(std::move(materials), balls, unknowns);
  }
  return LawFactors(hypothesis.believed, balls, unknowns);
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
      numbers_(numbers_of(hypothesis, seen.balls, unknowns_)),
      effects_(hypothesis.effects, hypothesis.fem != nullptr, unknowns_),
      reaches_the_measurement_(hold_a_fault(hypothesis.effects)),
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

const std::vector<std::size_t>& JointModel::unknowns_of_ball(std::size_t ball) const {
  return std::visit(
      [&](const auto& numbers) -> const auto& { return numbers.places(ball); }, numbers_);
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
    unknown.start = std::clamp(rise_time(data) - rise_time(model), unknown.lowest, unknown.highest);
  }
}

std::vector<double> JointModel::start() const {
  std::vector<double> values;
  for (const auto& unknown : unknowns_) values.push_back(unknown.start);
  return values;
}

}  // namespace rebound
