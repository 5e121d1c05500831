#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "comparisons/discrepancy/diagnosis/fits/curve_numbers.hpp"
#include "comparisons/discrepancy/diagnosis/fits/joint_search.hpp"
#include "comparisons/discrepancy/diagnosis/fits/white_noise_search.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/inference/calibration/differences.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr int first_look_iterations = 10, first_look_in_fem = 6;

/// N: samples that are alike count for less than as many that are not.
double independent_data(const Observations& seen, const JointModel& model) {
  std::vector<double> share, of_deflection;
  for (const MeasuredImpact& shot : seen.shots) {
    share.push_back(effective_share(shot.noise.autocorrelation));
    of_deflection.push_back(effective_share(shot.deflection_noise.autocorrelation));
  }
  double count = 0.0;
  for (const DataRow& row : model.rows())
    count += row.what == ObservedQuantity::force        ? share[row.shot]
             : row.what == ObservedQuantity::deflection ? of_deflection[row.shot]
                                                        : 1.0;
  return std::max(2.0, count);
}

/// With each choice that a search has made for effect k. To choose a switch, or one of the shots,
/// is a choice.
double with_choices(const HypothesisFit& fit, std::size_t k, double numbers) {
  for (const EffectParameterCard& one : find_effect(fit.effects[k].name).card.parameters)
    if (one.kind == ParameterKind::shot) numbers += 1.0;
  return std::max(1.0, numbers);
}

/// What effect k costs a criterion: numbers that are fitted, and choices.
CostOfNumbers cost_of(const HypothesisFit& fit, std::size_t k, const NumbersOfEffect& numbers,
                      double each) {
  CostOfNumbers cost = numbers.cost(each);
  cost.numbers = with_choices(fit, k, cost.numbers);
  return cost;
}

/// Numbers of an effect that a search picked from a grid: frequencies, and those of its shape that
/// the formula has at their defaults.
int picked_numbers(const EffectChoice& effect, bool of_fem) {
  const EffectCard& card = find_effect(effect.name).card;
  if (card.oscillator_pair) return 2;
  if (card.oscillator) return 1;
  return static_cast<int>(
      std::count_if(card.parameters.begin(), card.parameters.end(), [&](const auto& one) {
        const bool is_picked = one.dimension == dimension::frequency || one.is_left_open;
        return is_picked && one.tried.size() > 1 && is_unknown(one, of_fem, effect);
      }));
}

/// χ² + k ln N and χ² + 2 k.
void count_numbers(const Observations& seen, HypothesisFit& fit) {
  constexpr double each_of_prediction = 2.0;
  const double each = std::log(independent_data(seen, *fit.model));
  fit.effect_unknowns = fit.penalty_of_refits = 0.0;
  fit.information_criterion = fit.prediction_criterion = fit.chi_square;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const NumbersOfEffect numbers = numbers_of_effect(fit, k);
    const CostOfNumbers cost = cost_of(fit, k, numbers, each);
    fit.effect_unknowns += cost.numbers;
    fit.penalty_of_refits += each * with_choices(fit, k, all_numbers_of_effect(fit, k));
    fit.information_criterion += cost.with(each);
    const int picked = picked_numbers(fit.effects[k], fit.model->fem() != nullptr);
    fit.prediction_criterion +=
        cost_of(fit, k, numbers, each_of_prediction).with(each_of_prediction) +
        picked * std::max(0.0, each - each_of_prediction);
  }
}

/// Does a search leave no more than noise, so that there is nothing for another to find?
bool leaves_noise(const CalibrationResult& found) {
  return 2.0 * found.cost_after <= static_cast<double>(found.data);
}

/// The search that suits the noise, and the better of two where both may.
CalibrationResult searched(const Observations& seen, const JointModel& model,
                           CalibrationProblem& problem, SearchEffort effort,
                           const RunControl& control) {
  std::vector<Observations> stages = with_white_noise_beside(seen, model.hypothesis());
  const bool looks_first = effort == SearchEffort::first_look;
  if (looks_first && !stages.empty()) stages.resize(1);
  auto by_stages = search_by_stages(stages, model, problem, control);
  if (by_stages && !looks_first && leaves_noise(*by_stages)) return *by_stages;
  const bool is_steep = by_stages && !looks_first && acts_at_first_touch_alone(model.hypothesis());
  CalibrationResult found = is_steep ? search_from_both(model, problem, control)
                                     : search_joint_model(model, problem, control);
  if (by_stages && by_stages->cost_after < found.cost_after) return *by_stages;
  return found;
}

HypothesisFit fit_from(const Observations& seen, const Hypothesis& hypothesis,
                       const HypothesisFit* near, SearchEffort effort, const RunControl& control) {
  HypothesisFit fit;
  fit.hypothesis = hypothesis;
  const auto model = std::make_shared<const JointModel>(seen, hypothesis);
  fit.model = model;
  CalibrationProblem problem = model->problem();
  problem.controls = search_controls(*model);
  if (effort == SearchEffort::first_look)
    problem.controls.iterations = model->fem() ? first_look_in_fem : first_look_iterations;
  if (near) start_at(values_from(*near, *model), problem);
  if (problem.parameters.empty()) {
    fit.residuals = model->residuals({});
  } else {
    fit.search = searched(seen, *model, problem, effort, control);
    fit.values = fit.search.values();
    fit.residuals = model->residuals(fit.values);
  }
  model->forget_impacts();
  fit.effects = model->effects_at(fit.values);
  const std::size_t data = model->rows().size();
  for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
    const double square = fit.residuals[i] * fit.residuals[i];
    fit.chi_square += square;
    if (i < data) fit.data_chi_square += square;
  }
  const auto priors = static_cast<int>(fit.residuals.size() - data);
  fit.freedom =
      std::max(1, static_cast<int>(data) - (static_cast<int>(fit.values.size()) - priors));
  count_numbers(seen, fit);
  return fit;
}

}  // namespace

std::vector<std::string> added_effects(const HypothesisFit& fit, std::size_t known) {
  std::vector<std::string> names;
  for (std::size_t k = known; k < fit.effects.size(); ++k) names.push_back(fit.effects[k].name);
  return names;
}

std::vector<double> values_from(const HypothesisFit& fit, const JointModel& model) {
  std::map<std::string, double> fitted;
  for (std::size_t i = 0; i < fit.values.size(); ++i)
    fitted[fit.model->unknowns()[i].name] = fit.values[i];
  std::vector<double> values = model.start();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = fitted.find(model.unknowns()[i].name); found != fitted.end())
      values[i] = found->second;
  return values;
}

HypothesisFit fit_hypothesis(const Observations& seen, const Hypothesis& hypothesis,
                             const RunControl& control, SearchEffort effort) {
  return fit_from(seen, hypothesis, nullptr, effort, control);
}

HypothesisFit fit_extended(const Observations& seen, const HypothesisFit& near,
                           const std::vector<EffectChoice>& starts, SearchEffort effort,
                           const RunControl& control) {
  std::optional<HypothesisFit> best;
  Error failure(ExitCode::solver_failed, "the effect has no numbers to start from");
  for (const EffectChoice& start : starts) {
    Hypothesis one = near.hypothesis;
    one.effects = near.effects;
    one.effects.push_back(start);
    try {
      HypothesisFit fit = fit_from(seen, one, &near, effort, control);
      if (!best || fit.information_criterion < best->information_criterion) best = std::move(fit);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
      failure = error;
    }
  }
  if (!best) throw Error(failure);
  return std::move(*best);
}

HypothesisFit fit_further(const Observations& seen, const HypothesisFit& fit,
                          const RunControl& control) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  return fit_from(seen, hypothesis, &fit, SearchEffort::whole, control);
}

Eigen::MatrixXd jacobian_at(const JointModel& model, const std::vector<double>& values) {
  const ResidualsWithJacobian found = with_differences(
      model.unknowns(), [&](const std::vector<double>& x) { return model.residuals(x); }, values,
      model.difference_step());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(found.slopes.data(),
                                    static_cast<Eigen::Index>(found.residuals.size()),
                                    static_cast<Eigen::Index>(values.size()));
}

}  // namespace rebound
