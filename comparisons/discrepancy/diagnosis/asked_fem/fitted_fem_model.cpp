#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"

#include <algorithm>
#include <map>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/records_of_shots.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/inference/calibration/effect_unknowns.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

/// Of an effect's numbers that are no logarithms: a hundredth of their scale changes a force by
/// less than its ripple.
constexpr double longer_steps = 5.0;
constexpr double cost_tolerance = 3e-4;  // what nodes that touch one by one leave of the cost

/// Gain, speeds and starts of records begin where another fit to the same shots has left them.
void start_records_at(const std::vector<double>& values, std::ptrdiff_t first,
                      std::vector<CalibrationParameter>& unknowns) {
  if (values.size() + static_cast<std::size_t>(first) != unknowns.size()) return;
  for (std::size_t k = 0; k < values.size(); ++k) {
    CalibrationParameter& one = unknowns[static_cast<std::size_t>(first) + k];
    one.start = std::clamp(values[k], one.lowest, one.highest);
  }
}

/// Of the unknowns those that move an impact: numbers of the material, which come first, and of
/// physical effects. Gain, speed and start of a record do not, nor does a fault of the measurement.
std::vector<double> what_moves_an_impact(const std::vector<double>& x, std::size_t of_material,
                                         const EffectUnknowns& of_effects,
                                         const std::vector<EffectChoice>& effects) {
  std::vector<double> moving(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(of_material));
  for (std::size_t k = 0; k < effects.size(); ++k)
    if (!is_measurement(effects[k].name))
      for (const std::size_t place : of_effects.places(k)) moving.push_back(x[place]);
  return moving;
}

CalibrationControls controls_in_fem(Differences differences) {
  return {.relative_step = difference_step,
          .differences = differences,
          .runs_are_dear = true,
          .cost_tolerance = cost_tolerance,
          .iterations = 15};
}

/// Differences to one side are off by half the curvature of a step. Where the noise is small
/// against what a step changes, that ends a search in a valley far from its bottom. What leaves no
/// more than noise has no bottom to go to.
CalibrationResult searched(CalibrationProblem& problem, const RunControl& control,
                           SearchDepth depth) {
  problem.controls = controls_in_fem(Differences::one_sided);
  CalibrationResult near = calibrate(problem, control);
  const double left = 2.0 * near.cost_after / near.data;
  if (depth == SearchDepth::near || left <= 1.0 || left > far_from_data) return near;
  const std::vector<double> values = near.values();
  for (std::size_t k = 0; k < values.size(); ++k) problem.parameters[k].start = values[k];
  problem.controls = controls_in_fem(Differences::central);
  return calibrate(problem, control);
}

}  // namespace

FittedFem with_effects(FittedFem ball, const std::vector<EffectChoice>& effects) {
  FemProblem problem;
  apply_effects(physical_effects(effects), problem);
  if (problem.material.strain != StrainDependence{})
    for (PronyBranch& branch : ball.material.branches) branch.relaxes = Relaxes::all;
  ball.effects = effects;
  return ball;
}

std::vector<ModelledImpact> impacts_in_fem(const Observations& seen,
                                           const std::vector<std::size_t>& shots,
                                           const FemBelief& fem, const Material& material,
                                           const std::vector<EffectChoice>& effects) {
  const std::vector<EffectChoice> physical = physical_effects(effects);
  std::vector<ModelledImpact> impacts(shots.size());
  in_parallel(shots.size(), [&](std::size_t k) {
    const MeasuredImpact& shot = seen.shots[shots[k]];
    impacts[k] = fem.run(shot.ball, shot.impact, material, physical);
  });
  return impacts;
}

FittedFem fit_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                        const HypothesisFit& lumped, const FemBelief& fem,
                        const std::vector<EffectChoice>& effects, const FittedFem* near,
                        const RunControl& control, SearchDepth depth) {
  const Material guess = guess_fem_material(seen, shots, lumped);
  const MaterialUnknowns of_material(guess, near ? near->material : guess);
  CalibrationProblem calibration;
  of_material.add(calibration.parameters);
  const EffectUnknowns of_effects(effects, true, calibration.parameters);
  const auto physics = static_cast<std::ptrdiff_t>(calibration.parameters.size());
  for (std::size_t k = of_material.count(); k < calibration.parameters.size(); ++k)
    if (calibration.parameters[k].scale < 1.0) calibration.parameters[k].scale *= longer_steps;
  std::map<std::vector<double>, std::vector<ModelledImpact>> done;
  const auto impacts_at = [&](const std::vector<double>& x) -> const std::vector<ModelledImpact>& {
    return kept_answer(
        done, what_moves_an_impact(x, of_material.count(), of_effects, effects),
        [&] { return impacts_in_fem(seen, shots, fem, of_material.at(x), of_effects.at(x)); });
  };
  FirstTouches touches;
  for (const std::size_t shot : shots)
    touches[shot] = lumped.model->first_touch(lumped.values, shot);
  if (near && act_on_the_surface(effects)) {
    // The material is that of a fit: what is left of the start is the effect's.
    std::vector<double> first;
    for (const CalibrationParameter& one : calibration.parameters) first.push_back(one.start);
    touches = nearest_first_touches(seen, shots, impacts_at(first), effects, near->gain(), touches);
  }
  RecordsOfShots records(seen, shots);
  records.add_unknowns([&](std::size_t shot) { return touches.at(shot); }, calibration.parameters);
  if (near && !act_on_the_surface(effects))
    start_records_at(near->records, physics, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& x) {
    return records.residuals(x, impacts_at(x), of_effects.at(x));
  };
  calibration.noise = NoiseKnowledge::known;
  const CalibrationResult found = searched(calibration, control, depth);
  const std::vector<double> values = found.values();
  FittedFem fit{
      .material = of_material.at(values),
      .effects = of_effects.at(values),
      .records = {values.begin() + physics, values.end()},
      .chi_square = 2.0 * found.cost_after,
      .effect_unknowns = static_cast<double>(physics) - static_cast<double>(of_material.count())};
  for (const std::size_t i : shots) fit.samples += seen.shots[i].trace.force.size();
  return fit;
}

double chi_square_of(const Observations& shots_of, const std::vector<std::size_t>& shots,
                     const FemBelief& fem, const FittedFem& fitted, const RunControl& control) {
  const auto impacts = impacts_in_fem(shots_of, shots, fem, fitted.material, fitted.effects);
  CalibrationProblem calibration;
  RecordsOfShots records(shots_of, shots, fitted.gain());
  FirstTouches touches;
  for (std::size_t k = 0; k < shots.size(); ++k)
    touches[shots[k]] = rise_time(shots_of.shots[shots[k]].trace) - rise_time(impacts[k].trace);
  touches = nearest_first_touches(shots_of, shots, impacts, fitted.effects, fitted.gain(), touches);
  records.add_unknowns([&](std::size_t shot) { return touches.at(shot); }, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& x) {
    return records.residuals(x, impacts, fitted.effects);
  };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = controls_in_fem(Differences::one_sided);
  return 2.0 * calibrate(calibration, control).cost_after;
}

}  // namespace rebound
