#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "comparisons/discrepancy/diagnosis/asked_fem/records_of_shots.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/inference/calibration/effect_unknowns.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Poisson ratio where a search starts, and how far it may go: cells of plain bilinear kind.
constexpr double first_poisson_ratio = 0.35, least_poisson_ratio = 0.1, most_poisson_ratio = 0.45;
/// Time of the branch over that of the contact: loss without memory.
constexpr double first_time = 0.025, shortest_time = 0.004, longest_time = 0.08;
constexpr double first_ratio = 1.0, least_ratio = 1e-3, most_ratio = 20.0;
constexpr double difference_step = 0.02;  // of a logarithm: above FE's step noise
constexpr double cost_tolerance = 3e-4;   // what nodes that touch one by one leave of the cost
constexpr double reach = 3.0;             // of a logarithm, either way

/// ln E, Poisson ratio, ln of ratio and time of the branch.
using Numbers = std::array<double, 4>;

Material with_numbers(Material material, const Numbers& x) {
  material.youngs_modulus = std::exp(x[0]);
  material.poisson_ratio = x[1];
  material.branches.front() = {.ratio = std::exp(x[2]), .relaxation_time = std::exp(x[3])};
  return material;
}

/// Bounds are those about a guess; a search starts at `start`.
std::vector<CalibrationParameter> unknowns_near(const Material& guess, const Material& start) {
  const auto logarithm = [](const char* name, double first, double least, double most) {
    return CalibrationParameter{.name = name,
                                .unit = "ln SI",
                                .start = std::log(std::clamp(first, least, most)),
                                .lowest = std::log(least),
                                .highest = std::log(most),
                                .scale = 1.0};
  };
  const double far = std::exp(reach), modulus = guess.youngs_modulus;
  const PronyBranch& branch = guess.branches.front();
  const double contact = branch.relaxation_time / first_time;
  const PronyBranch& first = start.branches.front();
  return {logarithm("Young's modulus", start.youngs_modulus, modulus / far, modulus * far),
          {.name = "Poisson ratio",
           .unit = "1",
           .start = start.poisson_ratio,
           .lowest = least_poisson_ratio,
           .highest = most_poisson_ratio,
           .scale = 1.0},
          logarithm("branch ratio", first.ratio, least_ratio, most_ratio),
          logarithm("relaxation time", first.relaxation_time, shortest_time * contact,
                    longest_time * contact)};
}

std::vector<ModelledImpact> run_shots(const Observations& seen,
                                      const std::vector<std::size_t>& shots, const FemBelief& fem,
                                      const Material& material,
                                      const std::vector<EffectChoice>& effects) {
  std::vector<ModelledImpact> impacts(shots.size());
  in_parallel(shots.size(), [&](std::size_t k) {
    const MeasuredImpact& shot = seen.shots[shots[k]];
    impacts[k] = fem.run(shot.ball, shot.impact, material, effects);
  });
  return impacts;
}

CalibrationControls controls_in_fem() {
  return {.relative_step = difference_step,
          .differences = Differences::one_sided,
          .runs_are_dear = true,
          .cost_tolerance = cost_tolerance,
          .iterations = 15};
}

}  // namespace

Material guess_fem_material(const Observations& seen, const std::vector<std::size_t>& shots,
                            const HypothesisFit& lumped) {
  if (shots.empty()) throw Error(ExitCode::solver_failed, "no force history to fit an FE model to");
  const Sphere& sphere = seen.balls[seen.shots[shots.front()].ball].sphere;
  const ImpactScalars& scalars = lumped.model->impact(lumped.values, shots.front()).scalars;
  Material material;
  material.poisson_ratio = first_poisson_ratio;
  material.modulus = ModulusBasis::long_term;
  material.youngs_modulus = 0.6 * (1.0 - first_poisson_ratio * first_poisson_ratio) *
                            scalars.peak_force /
                            (std::sqrt(sphere.radius()) * std::pow(scalars.peak_deflection, 1.5));
  material.branches = {
      {.ratio = first_ratio, .relaxation_time = first_time * scalars.contact_time}};
  return material;
}

FittedFem fit_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                        const HypothesisFit& lumped, const FemBelief& fem,
                        const std::vector<EffectChoice>& effects, const FittedFem* near,
                        const RunControl& control) {
  const Material guess = guess_fem_material(seen, shots, lumped);
  CalibrationProblem calibration;
  calibration.parameters = unknowns_near(guess, near ? near->material : guess);
  const EffectUnknowns of_effects(effects, true, calibration.parameters);
  const auto physics = static_cast<std::ptrdiff_t>(calibration.parameters.size());
  const auto material_at = [&](const std::vector<double>& x) {
    return with_numbers(guess, {x[0], x[1], x[2], x[3]});
  };
  // A start or a scale moves no impact.
  std::map<std::vector<double>, std::vector<ModelledImpact>> done;
  const auto impacts_at = [&](const std::vector<double>& x) -> const std::vector<ModelledImpact>& {
    return kept_answer(done, {x.begin(), x.begin() + physics}, [&] {
      return run_shots(seen, shots, fem, material_at(x), of_effects.at(x));
    });
  };
  FirstTouches touches;
  for (const std::size_t shot : shots)
    touches[shot] = lumped.model->first_touch(lumped.values, shot);
  if (near && act_on_the_surface(effects)) {
    // The material is that of a fit: what is left of the start is the effect's.
    std::vector<double> first;
    for (const CalibrationParameter& one : calibration.parameters) first.push_back(one.start);
    touches = nearest_first_touches(seen, shots, impacts_at(first), touches);
  }
  RecordsOfShots records(seen, shots);
  records.add_unknowns([&](std::size_t shot) { return touches.at(shot); }, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& x) {
    return records.residuals(x, impacts_at(x));
  };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = controls_in_fem();
  const CalibrationResult found = calibrate(calibration, control);
  std::vector<double> values;
  for (const Estimate& estimate : found.estimates) values.push_back(estimate.value);
  FittedFem fit{.material = material_at(values),
                .effects = of_effects.at(values),
                .chi_square = 2.0 * found.cost_after,
                .effect_unknowns = static_cast<double>(physics) - std::tuple_size_v<Numbers>};
  for (const std::size_t i : shots) fit.samples += seen.shots[i].trace.force.size();
  return fit;
}

double chi_square_of(const Observations& shots_of, const std::vector<std::size_t>& shots,
                     const FemBelief& fem, const FittedFem& fitted, const RunControl& control) {
  const auto impacts = run_shots(shots_of, shots, fem, fitted.material, fitted.effects);
  CalibrationProblem calibration;
  RecordsOfShots records(shots_of, shots);
  FirstTouches touches;
  for (std::size_t k = 0; k < shots.size(); ++k)
    touches[shots[k]] = rise_time(shots_of.shots[shots[k]].trace) - rise_time(impacts[k].trace);
  touches = nearest_first_touches(shots_of, shots, impacts, touches);
  records.add_unknowns([&](std::size_t shot) { return touches.at(shot); }, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& x) {
    return records.residuals(x, impacts);
  };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = controls_in_fem();
  return 2.0 * calibrate(calibration, control).cost_after;
}

}  // namespace rebound
