#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"
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

/// What `second` has more of each scalar than `first`.
ScalarShares shares_added(const ImpactScalars& first, const ImpactScalars& second) {
  ScalarShares shares;
  for (std::size_t k = 0; k < shares.size(); ++k)
    shares[k] = second.*scalar_quantities[k].modelled / first.*scalar_quantities[k].modelled - 1.0;
  return shares;
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

namespace {

/// What FE says of one ball, on a mesh and on one of half the edge.
struct BallInFem {
  std::vector<ModelledImpact> impacts;  ///< on the finer mesh
  std::vector<KnownDifferences> known;  ///< what that mesh adds, at these speeds alone
  double error = 0.0;                   ///< of their histories, over the peak
  ScalarShares scalar_errors{};         ///< of their scalars
};

BallInFem run_ball(std::size_t ball, const std::vector<Impact>& impacts, const FittedFem& fitted,
                   const FemBelief& coarse, const FemBelief& fine) {
  // Of what half the edge changes, 1/(2^p - 1) is missing yet; at the edge of a contact p is 3/2.
  constexpr double still_missing = 0.547;
  BallInFem result;
  result.impacts.resize(impacts.size());
  result.known.resize(impacts.size());
  std::vector<double> errors(impacts.size());
  std::vector<ScalarShares> added(impacts.size());
  in_parallel(impacts.size(), [&](std::size_t i) {
    const ModelledImpact before = coarse.run(ball, impacts[i], fitted.material, fitted.effects);
    result.impacts[i] = fine.run(ball, impacts[i], fitted.material, fitted.effects);
    errors[i] = still_missing * history_difference(before, result.impacts[i]);
    added[i] = shares_added(before.scalars, result.impacts[i].scalars);
    result.known[i] = {.ball = ball,
                       .speed = impacts[i].speed,
                       .finer = difference_between(before, result.impacts[i]),
                       .faster = {},
                       .reach = 0.0};
  });
  result.error = *std::max_element(errors.begin(), errors.end());
  for (const ScalarShares& shares : added)
    for (std::size_t k = 0; k < shares.size(); ++k)
      result.scalar_errors[k] =
          std::max(result.scalar_errors[k], still_missing * std::abs(shares[k]));
  return result;
}

}  // namespace

ModelDiscrepancy measure_model_discrepancy(const Observations& all, const Observations& seen,
                                           const HypothesisFit& fit, const OwnMesh& own,
                                           const std::vector<EffectChoice>& plates,
                                           const RunControl& control) {
  FemProblem problem;
  problem.mesh_file = own.file;
  ModelDiscrepancy gap;
  gap.balls = fit_own_balls(all, seen, fit, problem, plates, control);
  std::vector<Material> materials;
  for (const FittedFem& ball : gap.balls) materials.push_back(ball.material);
  constexpr int one_halving = 1;
  const FemBelief coarse(problem, all, materials, search_cells, control);
  const FemBelief fine(problem, all, materials, search_cells, control, one_halving);
  gap.cells = {coarse.cells(), fine.cells()};
  std::vector<KnownDifferences> known;
  Hypothesis hypothesis = fit.hypothesis;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    if (!is_hit(all, ball)) continue;
    const std::vector<Impact> impacts = impacts_of(all, ball);
    const BallInFem in_fem = run_ball(ball, impacts, gap.balls[ball], coarse, fine);
    gap.numerical_uncertainty = std::max(gap.numerical_uncertainty, in_fem.error);
    for (std::size_t k = 0; k < scalar_quantities.size(); ++k)
      gap.scalar_uncertainty[k] = std::max(gap.scalar_uncertainty[k], in_fem.scalar_errors[k]);
    known.insert(known.end(), in_fem.known.begin(), in_fem.known.end());
    const Observations as_data = as_observed(all.balls[ball], impacts, in_fem.impacts);
    hypothesis.effects = effects_of_ball(fit.effects, ball);
    hypothesis.effects.insert(hypothesis.effects.end(), gap.balls[ball].effects.begin(),
                              gap.balls[ball].effects.end());
    const HypothesisFit lumped = fit_hypothesis(as_data, hypothesis, control);
    for (std::size_t i = 0; i < impacts.size(); ++i) {
      gap.curves.push_back(curve_of(lumped, i, impacts[i], in_fem.impacts[i]));
      gap.curves.back().ball = ball;
    }
  }
  gap.fem = std::make_shared<const FemBelief>(coarse.with(std::move(known)));
  return gap;
}

Observations with_numerical_uncertainty(Observations seen, const ModelDiscrepancy& gap) {
  for (MeasuredImpact& shot : seen.shots) {
    for (std::size_t k = 0; k < scalar_quantities.size(); ++k)
      if (Measured& one = shot.*scalar_quantities[k].measured; one.has_error())
        one.uncertainty = std::hypot(*one.uncertainty, gap.scalar_uncertainty[k] * *one.value);
    if (!shot.has_history()) continue;
    // It enters twice: in the fem_fit, and in the lumped model refitted to the fem_fit.
    add_numerical_error(shot,
                        std::sqrt(2.0) * gap.numerical_uncertainty * peak_of(shot.trace.force));
  }
  return seen;
}

}  // namespace rebound
