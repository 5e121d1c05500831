#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

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

/// Numbers that effect k costs: those that are fitted, and each choice that a search has made for
/// it. To choose a switch, or one of the shots, is a choice.
double numbers_of(const HypothesisFit& fit, std::size_t k) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  double numbers = 0.0;
  for (const EffectParameterCard& one : card.parameters)
    if (one.kind == ParameterKind::shot) numbers += 1.0;
  for (const std::size_t unknown : fit.model->unknowns_of_effect(k)) {
    const auto& prior = fit.model->unknowns()[unknown].prior;
    const double error = fit.search.estimates[unknown].standard_error;
    numbers += prior && std::isfinite(error)
                   ? 1.0 - std::min(1.0, std::pow(error / prior->deviation, 2))
                   : 1.0;
  }
  return std::max(1.0, numbers);
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
  const double each = std::log(independent_data(seen, *fit.model));
  fit.effect_unknowns = 0.0;
  int picked = 0;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    fit.effect_unknowns += numbers_of(fit, k);
    picked += picked_numbers(fit.effects[k], fit.model->fem() != nullptr);
  }
  fit.information_criterion = fit.chi_square + fit.effect_unknowns * each;
  fit.prediction_criterion =
      fit.chi_square + 2.0 * fit.effect_unknowns + picked * std::max(0.0, each - 2.0);
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
    const CalibrationProblem begun = problem;
    fit.search = search_joint_model(*model, problem, control);
    auto other = search_by_white_noise(seen, *model, begun, control);
    if (other && other->cost_after < fit.search.cost_after) fit.search = std::move(*other);
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

}  // namespace

double ShotGap::deviation() const {
  return rows > 0 ? std::sqrt(2.0 / rows) : 0.0;
}

std::vector<ShotGap> gaps_of_shots(const HypothesisFit& fit) {
  return shot_by_shot(*fit.model, fit.residuals);
}

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

HeldOutGap predict_unseen(const Observations& unseen, const HypothesisFit& fit) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  const JointModel model(unseen, hypothesis);
  std::vector<double> values = values_from(fit, model);
  const std::vector<double> unseen_starts = model.start();
  const auto& own = model.shot_nuisances();
  for (const std::size_t index : own) values[index] = unseen_starts[index];
  values = model.with_settled_starts(std::move(values));
  if (!own.empty()) {
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
  }
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
