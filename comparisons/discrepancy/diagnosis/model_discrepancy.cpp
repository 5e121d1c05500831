#include "comparisons/discrepancy/diagnosis/model_discrepancy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"
#include "comparisons/inference/calibration/material_calibration.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

constexpr double first_phase = -0.1, last_phase = 1.3;
constexpr int phases = 281;
constexpr double samples_per_contact = 400.0;
constexpr int coarse_cells = 500, fine_cells = 1000;
constexpr double fem_fit_noise = 0.01;  // of the peak: weights only

struct MeshPair {
  Mesh coarse, fine;
};

/// For the smallest contact of `impacts`. The guess's branch has gone by the time of the peak.
MeshPair meshes_for(FemProblem problem, const std::vector<Impact>& impacts, const OwnMesh& own,
                    const RunControl& control) {
  problem.material.branches.clear();
  problem.impact =
      *std::min_element(impacts.begin(), impacts.end(),
                        [](const auto& a, const auto& b) { return a.speed < b.speed; });
  problem.cells = coarse_cells;
  problem.mesh_file = own.file;
  Mesh coarse = mesh_for(problem, control);
  if (!own.file.empty()) {
    Mesh fine = refined_mesh(coarse, problem.sphere.radius());
    return {std::move(coarse), std::move(fine)};
  }
  problem.cells = fine_cells;
  return {std::move(coarse), mesh_for(problem, control)};
}

double peak_of(const std::vector<double>& force) {
  return *std::max_element(force.begin(), force.end());
}

/// Is the distance between the tiers at one of these speeds that at the other?
bool one_distance(double a, double b) {
  constexpr double alike = 0.02;  // of a speed: the distance changes as slowly as speed over c
  return std::abs(a - b) <= alike * b;
}

/// The speeds at which a ball was hit, repeats once.
std::vector<Impact> impacts_of(const Observations& all, std::size_t ball) {
  std::vector<Impact> impacts;
  for (const MeasuredImpact& shot : all.shots) {
    const bool known = std::any_of(impacts.begin(), impacts.end(), [&](const Impact& i) {
      return one_distance(i.speed, shot.impact.speed);
    });
    if (shot.ball == ball && !known) impacts.push_back({.speed = shot.impact.speed});
  }
  return impacts;
}

/// A shot with a history for each of these impacts, where there is one.
std::vector<std::size_t> without_repeats(const Observations& seen, std::size_t ball,
                                         const std::vector<Impact>& impacts) {
  std::vector<std::size_t> shots;
  for (const Impact& impact : impacts) {
    const auto first = std::find_if(seen.shots.begin(), seen.shots.end(), [&](const auto& shot) {
      return shot.ball == ball && shot.has_history() &&
             one_distance(impact.speed, shot.impact.speed);
    });
    if (first != seen.shots.end())
      shots.push_back(static_cast<std::size_t>(first - seen.shots.begin()));
  }
  return shots;
}

/// The fitted FE model's histories as if they had been measured.
Observations as_observed(const Ball& ball, const std::vector<Impact>& impacts,
                         const std::vector<FemResult>& results) {
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

double rms_difference(const Trace& a, const Trace& b) {
  double sum = 0.0;
  const std::vector<double> other = reported_force(b, {}, a.time);
  std::size_t count = 0;
  for (std::size_t i = 0; i < other.size() && a.time[i] <= b.time.back(); ++i, ++count)
    sum += (a.force[i] - other[i]) * (a.force[i] - other[i]);
  return std::sqrt(sum / static_cast<double>(count)) / peak_of(a.force);
}

DiscrepancyCurve curve_of(const HypothesisFit& fit, std::size_t shot, const Impact& impact,
                          const Trace& fem) {
  const ModelledImpact& lumped = fit.model->impact(fit.values, shot);
  DiscrepancyCurve curve{.speed = impact.speed,
                         .first_phase = first_phase,
                         .phase_step = (last_phase - first_phase) / (phases - 1)};
  std::vector<double> time;
  time.reserve(phases);
  for (int k = 0; k < phases; ++k)
    time.push_back((first_phase + k * curve.phase_step) * lumped.scalars.contact_time);
  const std::vector<double> model = reported_force(lumped.trace, {}, time);
  const MeasurementChain clock{.trigger_shift = -fit.model->first_touch(fit.values, shot)};
  const std::vector<double> fem_fit = reported_force(fem, clock, time);
  for (std::size_t k = 0; k < time.size(); ++k)
    curve.force.push_back((fem_fit[k] - model[k]) / lumped.scalars.peak_force);
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

Trace ModelDiscrepancy::added_to(const Trace& lumped, const ImpactScalars& scalars,
                                 std::size_t ball, double speed) const {
  const auto curve = std::find_if(curves.begin(), curves.end(), [&](const DiscrepancyCurve& c) {
    return c.ball == ball && one_distance(c.speed, speed);
  });
  if (curve == curves.end())
    throw Error(ExitCode::bad_input,
                fmt::format("no distance between the tiers at {:g} m/s", speed));
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

ModelDiscrepancy measure_model_discrepancy(const Observations& all, const Observations& seen,
                                           const HypothesisFit& fit, const OwnMesh& own,
                                           const RunControl& control) {
  Hypothesis hypothesis = fit.hypothesis;
  ModelDiscrepancy gap;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    const std::vector<Impact> impacts = impacts_of(all, ball);
    if (impacts.empty()) continue;
    const std::vector<std::size_t> shots = without_repeats(seen, ball, impacts);
    const MeshPair meshes = meshes_for(guess_fem_model(seen, shots, fit), impacts, own, control);
    gap.cells = {static_cast<int>(meshes.coarse.cells.size()),
                 static_cast<int>(meshes.fine.cells.size())};
    const FemProblem fem_fit = fit_fem_model(seen, shots, fit, meshes.fine, control);
    const auto fine =
        run_impacts(fem_fit, impacts, fem_runner(meshes.fine, fem_fit.sphere, control));
    const auto coarse =
        run_impacts(fem_fit, impacts, fem_runner(meshes.coarse, fem_fit.sphere, control));
    for (const auto* results : {&fine, &coarse})
      for (const FemResult& result : *results)
        if (!result.incomplete_because.empty())
          throw Error(ExitCode::solver_failed, "fitted FE model: " + result.incomplete_because);
    const Observations as_data = as_observed(all.balls[ball], impacts, fine);
    hypothesis.effects = effects_of_ball(fit.effects, ball);
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

Observations with_numerical_uncertainty(Observations seen, const ModelDiscrepancy& gap) {
  for (MeasuredImpact& shot : seen.shots) {
    if (!shot.has_history()) continue;
    // It enters twice: in the fem_fit, and in the lumped model refitted to the fem_fit.
    add_numerical_error(shot,
                        std::sqrt(2.0) * gap.numerical_uncertainty * peak_of(shot.trace.force));
  }
  return seen;
}

}  // namespace rebound
