#include "comparisons/calibration/material_calibration.hpp"

#include <cmath>
#include <string>

#include "comparisons/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

/// Differences smaller than this in a logarithm drown in the step noise of
/// the explicit scheme (about 1e-4 in contact time).
constexpr double difference_step = 0.02;
/// For the same reason no more of the cost can be gained than this share.
constexpr double cost_tolerance = 5e-4;

Material with_numbers(Material material, const std::vector<FreeMaterialNumber>& free,
                      const std::vector<double>& logarithms) {
  for (std::size_t i = 0; i < free.size(); ++i)
    number_of(material, free[i]) = std::exp(logarithms[i]);
  return material;
}

std::vector<double> residuals_of(const std::vector<FemResult>& results,
                                 const std::vector<MeasuredImpact>& measured) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!results[i].incomplete_because.empty())
      throw Error(ExitCode::solver_failed, results[i].incomplete_because);
    const double time = time_above(results[i].trace, measured[i].contact_threshold);
    residuals.push_back((results[i].scalars.restitution - measured[i].restitution) /
                        measured[i].restitution_uncertainty);
    residuals.push_back((time - measured[i].contact_time) / measured[i].contact_time_uncertainty);
  }
  return residuals;
}

/// From the logarithm back to the number itself.
void carry_back(Estimate& estimate) {
  estimate.standard_error *= std::exp(estimate.value);
  estimate.value = std::exp(estimate.value);
  estimate.low = std::exp(estimate.low);
  estimate.high = std::exp(estimate.high);
}

}  // namespace

std::vector<FemResult> run_impacts(const FemProblem& problem, const std::vector<Impact>& impacts,
                                   const FemRunner& run) {
  std::vector<FemResult> results(impacts.size());
  in_parallel(impacts.size(), [&](std::size_t i) {
    FemProblem one = problem;
    one.impact = impacts[i];
    results[i] = run(one);
  });
  return results;
}

MaterialCalibration calibrate_material(const FemProblem& problem,
                                       const std::vector<MeasuredImpact>& measured,
                                       const std::vector<FreeMaterialNumber>& free,
                                       const FemRunner& run, const RunControl& control,
                                       const MaterialSearch& search) {
  std::vector<Impact> impacts;
  for (const auto& shot : measured) impacts.push_back(shot.impact);

  CalibrationProblem calibration;
  calibration.noise = NoiseKnowledge::known;
  calibration.controls.relative_step = difference_step;
  calibration.controls.cost_tolerance = cost_tolerance;
  calibration.controls.iterations = 20;
  calibration.controls.confidence = search.confidence;
  calibration.controls.starts = search.starts;
  calibration.controls.seed = search.seed;
  calibration.controls.checkpoint = search.checkpoint;
  for (const auto& unknown : free) {
    Material start = problem.material;
    calibration.parameters.push_back({.name = name_of(unknown),
                                      .unit = unit_of(unknown.what),
                                      .start = std::log(number_of(start, unknown)),
                                      .lowest = std::log(unknown.lowest),
                                      .highest = std::log(unknown.highest)});
  }
  calibration.residuals = [&](const std::vector<double>& logarithms) {
    FemProblem one = problem;
    one.material = with_numbers(problem.material, free, logarithms);
    return residuals_of(run_impacts(one, impacts, run), measured);
  };

  MaterialCalibration result;
  result.fit = calibrate(calibration, control);
  std::vector<double> logarithms;
  for (auto& estimate : result.fit.estimates) {
    logarithms.push_back(estimate.value);
    carry_back(estimate);
  }
  result.material = with_numbers(problem.material, free, logarithms);
  return result;
}

}  // namespace rebound
