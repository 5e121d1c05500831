#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/settled_balls.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double first_phase = -0.1, last_phase = 1.3;
constexpr int phases = 281;
constexpr double samples_per_contact = 400.0;
constexpr double fem_fit_noise = 0.01;  // of the peak: weights only

double peak_of(const std::vector<double>& force) {
  return *std::max_element(force.begin(), force.end());
}

/// The fitted FE model's histories as if they had been measured.
Observations as_observed(const Ball& ball, const std::vector<Impact>& impacts,
                         const std::vector<ModelledImpact>& results) {
  Observations seen;
  seen.balls = {{.name = ball.name, .sphere = ball.sphere}};
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    seen.shots.push_back({.label = fmt::format("fitted FE model, {:g} m/s", impacts[i].speed),
                          .sphere = ball.sphere,
                          .impact = impacts[i],
                          .trace = {.time = results[i].trace.time, .force = results[i].trace.force},
                          .noise = {.deviation = fem_fit_noise * peak_of(results[i].trace.force)},
                          .restitution = {.value = results[i].scalars.restitution}});
  }
  return seen;
}

DiscrepancyCurve curve_of(const HypothesisFit& fit, std::size_t shot, const Impact& impact,
                          const ModelledImpact& fem) {
  const ModelledImpact& lumped = fit.model->impact(fit.values, shot);
  DiscrepancyCurve curve{.speed = impact.speed,
                         .first_phase = first_phase,
                         .phase_step = (last_phase - first_phase) / (phases - 1)};
  std::vector<double> time;
  time.reserve(phases);
  for (int k = 0; k < phases; ++k)
    time.push_back((first_phase + k * curve.phase_step) * lumped.scalars.contact_time);
  const std::vector<double> model = reported_force(contact_and_after(lumped, {}, time), {}, time);
  const MeasurementChain clock{.trigger_shift = -fit.model->first_touch(fit.values, shot)};
  const std::vector<double> fem_fit =
      reported_force(contact_and_after(fem, clock, time), clock, time);
  for (std::size_t k = 0; k < time.size(); ++k)
    curve.force.push_back((fem_fit[k] - model[k]) / lumped.scalars.peak_force);
  curve.scalars = shares_added(lumped.scalars, fem.scalars);
  return curve;
}

}  // namespace

double DiscrepancyCurve::at(double phase) const {
  const double place = (phase - first_phase) / phase_step;
  if (place < 0.0 || place >= static_cast<double>(force.size() - 1)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(i);
  return (1.0 - rest) * force[i] + rest * force[i + 1];
}

const DiscrepancyCurve& ModelDiscrepancy::curve_at(std::size_t ball, double speed) const {
  const auto curve = std::find_if(curves.begin(), curves.end(), [&](const DiscrepancyCurve& c) {
    return c.ball == ball && are_one_speed(c.speed, speed);
  });
  if (curve == curves.end())
    throw Error(ExitCode::bad_input,
                fmt::format("no distance between the tiers at {:g} m/s", speed));
  return *curve;
}

bool ModelDiscrepancy::plate_moves() const {
  return std::any_of(balls.begin(), balls.end(),
                     [](const FittedFem& ball) { return !ball.effects.empty(); });
}

double ModelDiscrepancy::ratio_of(const ScalarQuantity& scalar, std::size_t ball,
                                  double speed) const {
  const auto place = std::find_if(scalar_quantities.begin(), scalar_quantities.end(),
                                  [&](const auto& one) { return one.what == scalar.what; });
  const auto k = static_cast<std::size_t>(place - scalar_quantities.begin());
  return 1.0 + curve_at(ball, speed).scalars[k];
}

Trace ModelDiscrepancy::added_to(const Trace& lumped, const ImpactScalars& scalars,
                                 std::size_t ball, double speed) const {
  const DiscrepancyCurve& curve = curve_at(ball, speed);
  const double duration = scalars.contact_time;
  const double end = std::max(last_phase * duration, lumped.time.back());
  const double step = duration / samples_per_contact;
  Trace sum;
  for (double t = first_phase * duration; t <= end; t += step) sum.time.push_back(t);
  sum.force = reported_force(lumped, {}, sum.time);
  for (std::size_t i = 0; i < sum.time.size(); ++i)
    sum.force[i] += scalars.peak_force * curve.at(sum.time[i] / duration);
  return sum;
}

ModelDiscrepancy measure_model_discrepancy(const Observations& all, const Observations& seen,
                                           const LumpedAnswer& lumped, const OwnMesh& own,
                                           const RunControl& control) {
  const HypothesisFit& fit = lumped.law;
  FemProblem problem;
  problem.mesh_file = own.file;
  const SettledBalls settled = settle_balls(all, seen, lumped, problem, control);
  ModelDiscrepancy gap{.curves = {},
                       .numerical_uncertainty = settled.errors.of_history,
                       .scalar_uncertainty = settled.errors.of_scalars,
                       .cells = settled.cells,
                       .balls = settled.balls,
                       .fem = settled.fem,
                       .meshes = settled.meshes};
  Hypothesis hypothesis = fit.hypothesis;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    if (!is_hit(all, ball)) continue;
    const FittedFem& own_ball = gap.balls[ball];
    const std::vector<Impact> impacts = impacts_of(all, ball);
    std::vector<ModelledImpact> in_fem(impacts.size());
    in_parallel(impacts.size(), [&](std::size_t i) {
      in_fem[i] = gap.fem->run(ball, impacts[i], own_ball.material, own_ball.effects);
    });
    hypothesis.effects = effects_of_ball(fit.effects, ball);
    hypothesis.effects.insert(hypothesis.effects.end(), own_ball.effects.begin(),
                              own_ball.effects.end());
    const Observations as_data = as_observed(all.balls[ball], impacts, in_fem);
    const HypothesisFit refitted = fit_hypothesis(as_data, hypothesis, control);
    for (std::size_t i = 0; i < impacts.size(); ++i) {
      gap.curves.push_back(curve_of(refitted, i, impacts[i], in_fem[i]));
      gap.curves.back().ball = ball;
    }
  }
  return gap;
}

Observations with_numerical_uncertainty(Observations seen, const ModelDiscrepancy& gap) {
  // It enters twice: in the FE fit, and in the lumped model refitted to the FE fit.
  return with_errors_of_mesh(std::move(seen), std::sqrt(2.0) * gap.numerical_uncertainty,
                             gap.scalar_uncertainty);
}

}  // namespace rebound
