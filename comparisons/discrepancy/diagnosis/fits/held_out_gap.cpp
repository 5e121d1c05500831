#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "comparisons/discrepancy/diagnosis/fits/joint_search.hpp"
#include "comparisons/discrepancy/diagnosis/fits/white_noise_search.hpp"

namespace rebound {
namespace {

std::vector<ShotGap> shot_by_shot(const JointModel& model, const std::vector<double>& residuals) {
  std::vector<ShotGap> gaps;
  for (std::size_t i = 0; i < model.rows().size(); ++i) {
    gaps.resize(std::max(gaps.size(), model.rows()[i].shot + 1));
    ShotGap& gap = gaps[model.rows()[i].shot];
    ++gap.rows;
    gap.reduced_chi_square += residuals[i] * residuals[i];
  }
  for (ShotGap& gap : gaps)
    if (gap.rows > 0) gap.reduced_chi_square /= gap.rows;
  return gaps;
}

/// The numbers of the shots themselves, fitted, with all others as they are.
std::vector<double> with_own_numbers(const JointModel& model, std::vector<double> values) {
  const auto& own = model.shot_nuisances();
  if (own.empty()) return values;
  CalibrationProblem problem;
  for (const std::size_t index : own) {
    problem.parameters.push_back(model.unknowns()[index]);
    problem.parameters.back().start = values[index];
  }
  // Priors are among the residuals, those of what stays as fitted too.
  for (CalibrationParameter& unknown : problem.parameters) unknown.prior.reset();
  problem.residuals = [&](const std::vector<double>& free) {
    std::vector<double> all = values;
    for (std::size_t k = 0; k < own.size(); ++k) all[own[k]] = free[k];
    return model.residuals(all);
  };
  problem.noise = NoiseKnowledge::known;
  problem.controls = search_controls(model);
  const CalibrationResult found = calibrate(problem);
  for (std::size_t k = 0; k < own.size(); ++k) values[own[k]] = found.estimates[k].value;
  return values;
}

/// Of the shots themselves, by name.
using OwnNumbers = std::map<std::string, double>;

OwnNumbers own_numbers(const JointModel& model, const std::vector<double>& values) {
  OwnNumbers own;
  for (const std::size_t index : model.shot_nuisances())
    own[model.unknowns()[index].name] = values[index];
  return own;
}

/// What all shots share as fitted, and the numbers of the shots themselves fitted to them, from
/// those that are known and as the model starts.
std::vector<double> fitted_to_shots(const JointModel& model, const HypothesisFit& fit,
                                    const OwnNumbers& known) {
  constexpr int most_searches = 5;
  constexpr double worth_a_share = 0.01;  // of a gap that no start takes away
  std::vector<double> values = values_from(fit, model);
  const std::vector<double> starts = model.start();
  for (const std::size_t index : model.shot_nuisances()) {
    const auto found = known.find(model.unknowns()[index].name);
    values[index] = found == known.end() ? starts[index] : found->second;
  }
  values = with_own_numbers(model, model.with_settled_starts(std::move(values)));
  for (int count = 1; count < most_searches; ++count) {
    std::vector<double> settled = model.with_settled_starts(values);
    const double before = left_of(model, values);
    if (left_of(model, settled) > before - std::max(least_gain_of_a_search, worth_a_share * before))
      break;
    values = with_own_numbers(model, std::move(settled));
  }
  return values;
}

}  // namespace

double ShotGap::deviation() const {
  return rows > 0 ? std::sqrt(2.0 / rows) : 0.0;
}

std::vector<ShotGap> gaps_of_shots(const HypothesisFit& fit) {
  return shot_by_shot(*fit.model, fit.residuals);
}

HeldOutGap predict_unseen(const Observations& unseen, const HypothesisFit& fit) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  OwnNumbers own;
  for (const Observations& stage : with_white_noise_beside(unseen, hypothesis)) {
    const JointModel model(stage, hypothesis);
    own = own_numbers(model, fitted_to_shots(model, fit, own));
  }
  const JointModel model(unseen, hypothesis);
  const std::vector<double> values = fitted_to_shots(model, fit, own);
  const std::vector<double> residuals = model.residuals(values);
  HeldOutGap gap;
  const std::size_t data = model.rows().size();
  gap.deviation = std::sqrt(2.0 / static_cast<double>(data));
  // Noise that was estimated has an error of its own.
  if (unseen.noise_freedom > 0.0)
    gap.deviation = std::hypot(gap.deviation, std::sqrt(2.0 / unseen.noise_freedom));
  for (std::size_t i = 0; i < data; ++i) gap.chi_square += residuals[i] * residuals[i];
  gap.reduced_chi_square = gap.chi_square / static_cast<double>(data);
  gap.of_shots = shot_by_shot(model, residuals);
  for (std::size_t i = 0; i < unseen.shots.size(); ++i)
    gap.force.push_back(unseen.shots[i].has_history()
                            ? model.force_at(values, i, unseen.shots[i].trace.time)
                            : std::vector<double>{});
  return gap;
}

}  // namespace rebound
