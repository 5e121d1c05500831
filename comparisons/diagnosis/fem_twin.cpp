#include "comparisons/diagnosis/fem_twin.hpp"

#include <cmath>
#include <map>

#include "comparisons/calibration/material_calibration.hpp"
#include "comparisons/instrument/reported_force.hpp"
#include "comparisons/modules/fem_runner.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double poisson_ratio = 0.4;
constexpr double fast_branch = 0.025;    // of the contact time: loss without memory
constexpr double speed_exponent = 1.2;   // of the peak force (Hertz)
constexpr double difference_step = 0.02; // of a logarithm: above FE's step noise
constexpr double cost_tolerance = 1e-3;
constexpr double reach = 3.0;            // of a logarithm, either way

/// The histories of one ball against FE, as a calibration.
class TwinResiduals {
 public:
  TwinResiduals(const Observations& seen, std::size_t ball, FemRunner run)
      : seen_(seen), run_(std::move(run)) {
    for (std::size_t i = 0; i < seen.shots.size(); ++i) {
      if (seen.shots[i].ball != ball || !seen.shots[i].history) continue;
      shots_.push_back(i);
      impacts_.push_back({.speed = seen.shots[i].speed});
    }
    if (shots_.empty()) throw Error(ExitCode::solver_failed, "no force history to fit an FE twin to");
  }

  const std::vector<std::size_t>& shots() const { return shots_; }

  /// Unknowns: ln E, ln ratio, then scale and start of every shot.
  std::vector<double> operator()(const FemProblem& start, const std::vector<double>& values) {
    const auto& results = impacts(start, values[0], values[1]);
    std::vector<double> residuals;
    for (std::size_t k = 0; k < shots_.size(); ++k) {
      const ObservedShot& shot = seen_.shots[shots_[k]];
      const double scale = values[2 + 2 * k], first_touch = values[3 + 2 * k];
      const MeasurementChain chain{.force_gain = scale, .trigger_shift = first_touch};
      const auto force = reported_force(results[k].trace, chain, shot.history->time);
      for (std::size_t j = 0; j < force.size(); ++j)
        residuals.push_back((force[j] - shot.history->force[j]) / shot.history->noise);
      residuals.push_back(scale / scale_uncertainty(shot));
    }
    return residuals;
  }

  double scale_uncertainty(const ObservedShot& shot) const {
    return std::hypot(seen_.gain_uncertainty, speed_exponent * shot.speed_uncertainty / shot.speed) +
           1e-4;
  }

 private:
  const std::vector<FemResult>& impacts(FemProblem problem, double modulus, double ratio) {
    const auto [place, added] = done_.try_emplace({modulus, ratio});
    if (!added) return place->second;
    problem.material.youngs_modulus = std::exp(modulus);
    problem.material.branches.front().ratio = std::exp(ratio);
    place->second = run_impacts(problem, impacts_, run_);
    for (const FemResult& result : place->second)
      if (!result.incomplete_because.empty())
        throw Error(ExitCode::solver_failed, "FE twin: " + result.incomplete_because);
    return place->second;
  }

  const Observations& seen_;
  FemRunner run_;
  std::vector<std::size_t> shots_;
  std::vector<Impact> impacts_;
  std::map<std::pair<double, double>, std::vector<FemResult>> done_;
};

/// Hertz from the lumped peak, less what the branch adds.
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

FemProblem fit_fem_twin(const Observations& seen, std::size_t ball, const HypothesisFit& lumped,
                        int cells, const RunControl& control) {
  const Sphere& sphere = seen.balls[ball].sphere;
  TwinResiduals twin(seen, ball, fem_runner(sphere, cells, control));
  const std::size_t reference = twin.shots().front();
  FemProblem problem = first_guess(sphere, lumped.model->impact(lumped.values, reference).scalars);

  CalibrationProblem calibration;
  const auto add_logarithm = [&](const char* name, double start) {
    calibration.parameters.push_back({.name = name, .unit = "ln SI", .start = std::log(start),
                                      .lowest = std::log(start) - reach,
                                      .highest = std::log(start) + reach, .scale = 1.0});
  };
  add_logarithm("Young's modulus", problem.material.youngs_modulus);
  add_logarithm("branch ratio", problem.material.branches.front().ratio);
  for (const std::size_t i : twin.shots()) {
    const ForceHistory& history = *seen.shots[i].history;
    const double span = history.time.back() - history.time.front();
    calibration.parameters.push_back({.name = "scale, " + seen.shots[i].label, .unit = "1",
                                      .start = 0.0, .lowest = -0.5, .highest = 0.5,
                                      .scale = twin.scale_uncertainty(seen.shots[i])});
    calibration.parameters.push_back({.name = "start, " + seen.shots[i].label, .unit = "s",
                                      .start = lumped.model->first_touch(lumped.values, i),
                                      .lowest = history.time.front() - span,
                                      .highest = history.time.back(), .scale = 1e-2 * span});
  }
  calibration.residuals = [&](const std::vector<double>& values) { return twin(problem, values); };
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = {.relative_step = difference_step, .cost_tolerance = cost_tolerance,
                          .iterations = 12};
  const CalibrationResult found = calibrate(calibration, control);
  problem.material.youngs_modulus = std::exp(found.estimates[0].value);
  problem.material.branches.front().ratio = std::exp(found.estimates[1].value);
  return problem;
}

}  // namespace rebound
