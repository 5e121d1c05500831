#include "comparisons/diagnosis/tier_gap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/calibration/material_calibration.hpp"
#include "comparisons/diagnosis/fem_twin.hpp"
#include "comparisons/diagnosis/hypothesis_fit.hpp"
#include "comparisons/instrument/reported_force.hpp"
#include "comparisons/modules/fem_runner.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double first_phase = -0.1, last_phase = 1.3;
constexpr int phases = 281;
constexpr double samples_per_contact = 400.0;
constexpr int coarse_cells = 500, fine_cells = 1000;
constexpr double twin_noise = 0.01;    // of the peak: weights only

double peak_of(const std::vector<double>& force) {
  return *std::max_element(force.begin(), force.end());
}

/// Every nominal speed at which the ball was hit, once.
std::vector<Impact> impacts_of(const Observations& all, std::size_t ball) {
  std::vector<Impact> impacts;
  for (const ObservedShot& shot : all.shots) {
    const bool known = std::any_of(impacts.begin(), impacts.end(),
                                   [&](const Impact& i) { return i.speed == shot.speed; });
    if (shot.ball == ball && !known) impacts.push_back({.speed = shot.speed});
  }
  return impacts;
}

/// The twin's histories as if they had been measured.
Observations as_observed(const ObservedBall& ball, const std::vector<Impact>& impacts,
                         const std::vector<FemResult>& results) {
  Observations seen;
  seen.balls = {{.name = ball.name, .sphere = ball.sphere}};
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    ForceHistory history{.time = results[i].trace.time, .force = results[i].trace.force,
                         .noise = twin_noise * peak_of(results[i].trace.force)};
    seen.shots.push_back({.label = fmt::format("FE twin, {:g} m/s", impacts[i].speed), .ball = 0,
                          .speed = impacts[i].speed, .history = std::move(history),
                          .restitution = results[i].scalars.restitution});
  }
  return seen;
}

double rms_difference(const Trace& a, const Trace& b) {
  double sum = 0.0;
  const std::vector<double> other = reported_force(b, {}, a.time);
  std::size_t count = 0;
  for (std::size_t i = 0; i < other.size() && a.time[i] <= b.time.back(); ++i, ++count)
    sum += (a.force[i] - other[i]) * (a.force[i] - other[i]);
  return std::sqrt(sum / static_cast<double>(count)) / peak_of(a.force);
}

TierGapCurve curve_of(const HypothesisFit& fit, std::size_t shot, const Impact& impact,
                      const Trace& fem) {
  const LumpedResult& lumped = fit.model->impact(fit.values, shot);
  TierGapCurve curve{.speed = impact.speed, .first_phase = first_phase,
                     .phase_step = (last_phase - first_phase) / (phases - 1)};
  std::vector<double> time;
  for (int k = 0; k < phases; ++k)
    time.push_back((first_phase + k * curve.phase_step) * lumped.scalars.contact_time);
  const std::vector<double> model = reported_force(lumped.trace, {}, time);
  const MeasurementChain clock{.trigger_shift = -fit.model->first_touch(fit.values, shot)};
  const std::vector<double> twin = reported_force(fem, clock, time);
  for (std::size_t k = 0; k < time.size(); ++k)
    curve.force.push_back((twin[k] - model[k]) / lumped.scalars.peak_force);
  return curve;
}

}  // namespace

double TierGapCurve::at(double phase) const {
  const double place = (phase - first_phase) / phase_step;
  if (place < 0.0 || place >= static_cast<double>(force.size() - 1)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(i);
  return (1.0 - rest) * force[i] + rest * force[i + 1];
}

Trace TierGap::added_to(const Trace& lumped, const ImpactScalars& scalars, std::size_t ball,
                        double speed) const {
  const auto curve = std::find_if(curves.begin(), curves.end(), [&](const TierGapCurve& c) {
    return c.ball == ball && c.speed == speed;
  });
  if (curve == curves.end())
    throw Error(ExitCode::bad_input, fmt::format("no distance between the tiers at {:g} m/s", speed));
  const double duration = scalars.contact_time;
  const double end = std::max(last_phase * duration, lumped.time.back());
  const double step = duration / samples_per_contact;
  Trace sum;
  for (double t = first_phase * duration; t <= end; t += step) sum.time.push_back(t);
  sum.force = reported_force(lumped, {}, sum.time);
  for (std::size_t i = 0; i < sum.time.size(); ++i)
    sum.force[i] += scalars.peak_force * curve->at(sum.time[i] / duration);
  return sum;
}

TierGap measure_tier_gap(const Observations& all, const Observations& seen,
                         const HypothesisFit& fit, const RunControl& control) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  TierGap gap;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    const std::vector<Impact> impacts = impacts_of(all, ball);
    if (impacts.empty()) continue;
    const FemProblem twin = fit_fem_twin(seen, ball, fit, fine_cells, control);
    const auto fine = run_impacts(twin, impacts, fem_runner(twin.sphere, fine_cells, control));
    const auto coarse = run_impacts(twin, impacts, fem_runner(twin.sphere, coarse_cells, control));
    for (const auto* results : {&fine, &coarse})
      for (const FemResult& result : *results)
        if (!result.incomplete_because.empty())
          throw Error(ExitCode::solver_failed, "FE twin: " + result.incomplete_because);
    const Observations as_data = as_observed(all.balls[ball], impacts, fine);
    const HypothesisFit lumped = fit_hypothesis(as_data, hypothesis, control);
    for (std::size_t i = 0; i < impacts.size(); ++i) {
      gap.curves.push_back(curve_of(lumped, i, impacts[i], fine[i].trace));
      gap.curves.back().ball = ball;
      gap.numerical_uncertainty =
          std::max(gap.numerical_uncertainty, rms_difference(fine[i].trace, coarse[i].trace));
    }
  }
  return gap;
}

Observations with_numerical_uncertainty(Observations seen, const TierGap& gap) {
  constexpr std::size_t blocks = 8;  // of a history: about six in a contact, as many as it has phases
  for (ObservedShot& shot : seen.shots) {
    if (!shot.history) continue;
    ForceHistory& history = *shot.history;
    // It enters twice: in the twin, and in the lumped model refitted to the twin.
    const double error = std::sqrt(2.0) * gap.numerical_uncertainty * peak_of(history.force);
    // The ripple of the contact front is white, what a mesh gets wrong is not.
    history.noise = std::hypot(history.noise, error);
    history.shared_error = error;
    history.shared_by = std::max<std::size_t>(1, history.force.size() / blocks);
  }
  return seen;
}

}  // namespace rebound
