#include "comparisons/discrepancy/diagnosis/fitted_fem_model.hpp"

#include <cmath>
#include <map>

#include "comparisons/inference/calibration/material_calibration.hpp"
#include "comparisons/inference/calibration/nuisances.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double poisson_ratio = 0.4;
constexpr double fast_branch = 0.025;     // of the contact time: loss without memory
constexpr double speed_exponent = 1.2;    // of the peak force (Hertz)
constexpr double difference_step = 0.02;  // of a logarithm: above FE's step noise
constexpr double cost_tolerance = 1e-3;
constexpr double reach = 3.0;  // of a logarithm, either way

/// Histories of one ball against FE, as a calibration.
///
///   unknowns   ln E, ln ratio; for every shot a gain, within what gain and speed leave open,
///              and a start
class FemHistories {
 public:
  FemHistories(const Observations& seen, std::vector<std::size_t> shots, FemRunner run)
      : seen_(seen), run_(std::move(run)), nuisances_(seen.shots.size()), shots_(std::move(shots)) {
    for (const std::size_t i : shots_) impacts_.push_back({.speed = seen.shots[i].impact.speed});
  }

  /// Behind the numbers of the material.
  void add_nuisances(const HypothesisFit& lumped, std::vector<CalibrationParameter>& unknowns) {
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
                      .start = lumped.model->first_touch(lumped.values, i),
                      .lowest = first - (last - first),
                      .highest = last,
                      .scale = 1e-2 * (last - first)},
                     {i}, unknowns);
    }
  }

  std::vector<double> residuals(const FemProblem& start, const std::vector<double>& values) {
    const auto& results = impacts(start, values[0], values[1]);
    std::vector<double> residuals;
    for (std::size_t k = 0; k < shots_.size(); ++k) {
      const MeasuredImpact& shot = seen_.shots[shots_[k]];
      MeasurementChain chain;
      nuisances_.apply(values, shots_[k], chain);
      const auto r = whitened(shot, reported_force(results[k].trace, chain, shot.trace.time));
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

  const std::vector<FemResult>& impacts(FemProblem problem, double modulus, double ratio) {
    const auto [place, added] = done_.try_emplace({modulus, ratio});
    if (!added) return place->second;
    problem.material.youngs_modulus = std::exp(modulus);
    problem.material.branches.front().ratio = std::exp(ratio);
    place->second = run_impacts(problem, impacts_, run_);
    for (const FemResult& result : place->second)
      if (!result.incomplete_because.empty())
        throw Error(ExitCode::solver_failed, "fitted FE model: " + result.incomplete_because);
    return place->second;
  }

  const Observations& seen_;
  FemRunner run_;
  NuisanceUnknowns nuisances_;
  std::vector<std::size_t> shots_;
  std::vector<Impact> impacts_;
  std::map<std::pair<double, double>, std::vector<FemResult>> done_;
};

FemProblem first_guess(const Sphere& sphere, const ImpactScalars& scalars) {
  FemProblem problem;
  problem.sphere = sphere;
  problem.material.poisson_ratio = poisson_ratio;
  problem.material.modulus = ModulusBasis::long_term;
  problem.material.youngs_modulus =
      0.45 * (1.0 - poisson_ratio * poisson_ratio) * scalars.peak_force /
      (std::sqrt(sphere.radius()) * std::pow(scalars.peak_deflection, 1.5));
  problem.material.branches = {
      {.ratio = 3.0, .relaxation_time = fast_branch * scalars.contact_time}};
  return problem;
}

}  // namespace

FemProblem guess_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                           const HypothesisFit& lumped) {
  if (shots.empty()) throw Error(ExitCode::solver_failed, "no force history to fit an FE model to");
  return first_guess(seen.balls[seen.shots[shots.front()].ball].sphere,
                     lumped.model->impact(lumped.values, shots.front()).scalars);
}

FemProblem fit_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                         const HypothesisFit& lumped, const Mesh& mesh, const RunControl& control) {
  FemProblem problem = guess_fem_model(seen, shots, lumped);
  FemHistories fem_fit(seen, shots, fem_runner(mesh, problem.sphere, control));

  CalibrationProblem calibration;
  const auto add_logarithm = [&](const char* name, double start) {
    calibration.parameters.push_back({.name = name,
                                      .unit = "ln SI",
                                      .start = std::log(start),
                                      .lowest = std::log(start) - reach,
                                      .highest = std::log(start) + reach,
                                      .scale = 1.0});
  };
  add_logarithm("Young's modulus", problem.material.youngs_modulus);
  add_logarithm("branch ratio", problem.material.branches.front().ratio);
  fem_fit.add_nuisances(lumped, calibration.parameters);
  calibration.residuals = [&](const std::vector<double>& values) {
    return fem_fit.residuals(problem, values);
  };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = {
      .relative_step = difference_step, .cost_tolerance = cost_tolerance, .iterations = 12};
  const CalibrationResult found = calibrate(calibration, control);
  problem.material.youngs_modulus = std::exp(found.estimates[0].value);
  problem.material.branches.front().ratio = std::exp(found.estimates[1].value);
  return problem;
}

}  // namespace rebound
