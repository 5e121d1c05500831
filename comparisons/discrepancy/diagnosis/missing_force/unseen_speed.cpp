#include "comparisons/discrepancy/diagnosis/missing_force/unseen_speed.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/missing_force/driven_contact.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

/// The loop at a speed: a power of the speed between two neighbours and beyond.
Loop loop_at(const ForceRows& rows, double speed) {
  const std::vector<double>& speeds = rows.speeds();
  const Loop& first = rows.samples_at(0).loop;
  constexpr double hertz = 0.8;  // power of the speed by which a Hertz contact gives way
  if (speeds.size() == 1)
    return {first.largest_deflection * std::pow(speed / speeds.front(), hertz), first.end};
  std::size_t above = 1;
  while (above + 1 < speeds.size() && speeds[above] < speed) ++above;
  const Loop &low = rows.samples_at(above - 1).loop, &high = rows.samples_at(above).loop;
  const double share =
      std::log(speed / speeds[above - 1]) / std::log(speeds[above] / speeds[above - 1]);
  return {
      low.largest_deflection * std::pow(high.largest_deflection / low.largest_deflection, share),
      low.end + share * (high.end - low.end)};
}

/// One shot that no fit saw, under the law and a force beside it.
class UnseenShot {
 public:
  UnseenShot(const Observations& unseen, const JointModel& model, std::vector<double> values,
             std::size_t shot)
      : unseen_(unseen), model_(model), values_(std::move(values)), shot_(shot) {
    for (const NuisancePlace& place : model.nuisances_of(shot)) {
      const auto& own = model.shot_nuisances();
      if (std::find(own.begin(), own.end(), place.unknown) == own.end()) continue;
      own_.push_back(place.unknown);
      values_[place.unknown] = model.unknowns()[place.unknown].start;
    }
  }

  /// χ² of its history once its own start and speed are found.
  double chi_square(const ForceBeside& beside) const {
    CalibrationProblem problem;
    for (const std::size_t unknown : own_) problem.parameters.push_back(model_.unknowns()[unknown]);
    problem.residuals = [&](const std::vector<double>& free) { return residuals(free, beside); };
    problem.noise = NoiseKnowledge::known;
    problem.controls.iterations = 30;
    double sum = 0.0;
    for (const double r : residuals(calibrate(problem).values(), beside)) sum += r * r;
    return sum;
  }

 private:
  std::vector<double> residuals(const std::vector<double>& free, const ForceBeside& beside) const {
    std::vector<double> values = values_;
    for (std::size_t k = 0; k < own_.size(); ++k) values[own_[k]] = free[k];
    const MeasuredImpact& measured = unseen_.shots[shot_];
    const Trace trace = impact_with(model_.problem_at(values, shot_), beside);
    return whitened(measured,
                    reported_force(trace, model_.chain_at(values, shot_), measured.trace.time));
  }

  const Observations& unseen_;
  const JointModel& model_;
  std::vector<double> values_;
  std::size_t shot_;
  std::vector<std::size_t> own_;
};

}  // namespace

void predict_with_missing_force(const Observations& unseen, std::size_t ball,
                                const HypothesisFit& fit, const FoundForce& found,
                                MissingForce& missing) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  if (hypothesis.model_discrepancy) return;  // FE's own part belongs to another motion
  const JointModel model(unseen, hypothesis);
  HypothesisFit moved = fit;
  moved.values = found.values;
  const std::vector<double> without = values_from(fit, model), with = values_from(moved, model);
  double before = 0.0, after = 0.0;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < unseen.shots.size(); ++i) {
    if (unseen.shots[i].ball != ball || !unseen.shots[i].has_history()) continue;
    const double speed = unseen.shots[i].impact.speed;
    const Loop loop = loop_at(found.rows, speed);
    const Eigen::VectorXd coefficients = found.surface.coefficients_at(speed);
    before += UnseenShot(unseen, model, without, i)
                  .chi_square({[](double, double) { return 0.0; },
                               [](double x, double v) { return v < 0.0 && x < 0.0; }});
    after += UnseenShot(unseen, model, with, i)
                 .chi_square({[&](double x, double v) {
                                return LoopSplines::at(loop.position(x, v)).dot(coefficients);
                              },
                              [&](double x, double v) { return loop.angle(x, v) >= loop.end; }});
    rows += unseen.shots[i].trace.time.size();
  }
  if (rows == 0) return;
  missing.unseen_before = before / static_cast<double>(rows);
  missing.unseen_after = after / static_cast<double>(rows);
}

}  // namespace rebound
