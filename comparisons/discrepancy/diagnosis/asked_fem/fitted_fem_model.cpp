#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"
#include "comparisons/inference/calibration/effect_unknowns.hpp"
#include "comparisons/inference/calibration/nuisances.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Poisson ratio where a search starts, and how far it may go: cells of plain bilinear kind.
constexpr double first_poisson_ratio = 0.35, least_poisson_ratio = 0.1, most_poisson_ratio = 0.45;
/// Time of the branch over that of the contact: loss without memory.
constexpr double first_time = 0.025, shortest_time = 0.004, longest_time = 0.08;
constexpr double first_ratio = 1.0, least_ratio = 1e-3, most_ratio = 20.0;
constexpr double speed_exponent = 1.2;    // of the peak force (Hertz)
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

/// Records of some shots beside impacts of any physics.
///
///   unknowns   for every shot a scale, within what gain and speed leave open, and a start
class Records {
 public:
  Records(const Observations& seen, const std::vector<std::size_t>& shots)
      : seen_(seen), shots_(shots), nuisances_(seen.shots.size()) {}

  /// `first_touch`: where a search for the start of a shot begins [s].
  void add_unknowns(const std::function<double(std::size_t shot)>& first_touch,
                    std::vector<CalibrationParameter>& unknowns) {
    for (const std::size_t i : shots_) {
      const MeasuredImpact& shot = seen_.shots[i];
      const double deviation = scale_uncertainty(shot);
      nuisances_.add(find_nuisance("gain"),
                     {.name = "scale, " + shot.label,
                      .unit = "1",
                      .start = 0.0,
                      .lowest = -0.5,
                      .highest = 0.5,
                      .scale = deviation,
                      .prior = Prior{0.0, deviation}},
                     {i}, unknowns);
      const double first = shot.trace.time.front(), last = shot.trace.time.back();
      nuisances_.add(find_nuisance("trigger"),
                     {.name = "start, " + shot.label,
                      .unit = "s",
                      .start = first_touch(i),
                      .lowest = first - (last - first),
                      .highest = last,
                      .scale = 1e-2 * (last - first)},
                     {i}, unknowns);
    }
  }

  std::vector<double> residuals(const std::vector<double>& values,
                                const std::vector<ModelledImpact>& impacts) const {
    std::vector<double> residuals;
    for (std::size_t k = 0; k < shots_.size(); ++k) {
      const MeasuredImpact& shot = seen_.shots[shots_[k]];
      MeasurementChain chain = stated_chain(shot);
      nuisances_.apply(values, shots_[k], chain);
      const auto& time = shot.trace.time;
      const auto r =
          whitened(shot, reported_force(contact_and_after(impacts[k], chain, time), chain, time));
      residuals.insert(residuals.end(), r.begin(), r.end());
    }
    return residuals;
  }

 private:
  double scale_uncertainty(const MeasuredImpact& shot) const {
    return std::hypot(seen_.gain_uncertainty,
                      speed_exponent * shot.speed_uncertainty.value_or(0.0) / shot.impact.speed) +
           1e-4;
  }

  const Observations& seen_;
  const std::vector<std::size_t>& shots_;
  NuisanceUnknowns nuisances_;
};

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
  Records records(seen, shots);
  records.add_unknowns(
      [&](std::size_t shot) { return lumped.model->first_touch(lumped.values, shot); },
      calibration.parameters);
  const auto material_at = [&](const std::vector<double>& x) {
    return with_numbers(guess, {x[0], x[1], x[2], x[3]});
  };
  // A start or a scale moves no impact.
  std::map<std::vector<double>, std::vector<ModelledImpact>> done;
  calibration.residuals = [&](const std::vector<double>& x) {
    const auto& impacts = kept_answer(done, {x.begin(), x.begin() + physics}, [&] {
      return run_shots(seen, shots, fem, material_at(x), of_effects.at(x));
    });
    return records.residuals(x, impacts);
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
  Records records(shots_of, shots);
  std::map<std::size_t, double> starts;
  for (std::size_t k = 0; k < shots.size(); ++k)
    starts[shots[k]] = rise_time(shots_of.shots[shots[k]].trace) - rise_time(impacts[k].trace);
  records.add_unknowns([&](std::size_t shot) { return starts.at(shot); }, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& x) {
    return records.residuals(x, impacts);
  };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = controls_in_fem();
  return 2.0 * calibrate(calibration, control).cost_after;
}

}  // namespace rebound
