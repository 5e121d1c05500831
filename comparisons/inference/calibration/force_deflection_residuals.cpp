#include "comparisons/inference/calibration/force_deflection_residuals.hpp"

#include <algorithm>

#include "comparisons/inference/calibration/reference_checks.hpp"
#include "comparisons/inference/calibration/residual_slopes.hpp"
#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {

ForceDeflectionResiduals::ForceDeflectionResiduals(const std::vector<MeasuredImpact>& shots,
                                                   const LawCalibrationOptions& options)
    : noise_(noise_of(shots)) {
  for (const auto& shot : shots) {
    check_reference(shot);
    Prepared prepared{&shot, {}, {}, weight_of(shot, noise_, options.weighting)};
    const DeflectionPoints all = deflection_points(shot.trace);
    const double tip = (1.0 - options.tip_margin) *
                       *std::max_element(all.deflection.begin(), all.deflection.end());
    for (std::size_t i = 0; i < all.deflection.size(); ++i) {
      if (all.deflection[i] > tip) continue;
      prepared.points.deflection.push_back(all.deflection[i]);
      prepared.points.branch.push_back(all.branch[i]);
      prepared.force.push_back(shot.trace.force[i]);
    }
    shots_.push_back(std::move(prepared));
  }
}

LumpedProblem ForceDeflectionResiduals::problem_for(const Prepared& prepared,
                                                    const LumpedModel& model,
                                                    const MeasurementChain& chain) const {
  LumpedProblem problem{.sphere = prepared.shot->sphere,
                        .impact = prepared.shot->impact,
                        .model = model,
                        .controls = {.relative_tolerance = fit_tolerance}};
  problem.sphere.mass /= 1.0 + chain.mass_error;
  problem.impact.speed /= 1.0 + chain.speed_error;
  return problem;
}

std::vector<double> ForceDeflectionResiduals::operator()(const ModelOfShot& model_of,
                                                         const ErrorsOfShot& errors_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const auto& [shot, points, reference, sigma] = shots_[k];
    const MeasurementChain chain = errors_of ? errors_of(k) : MeasurementChain{};
    const std::vector<double> model = forces_at(problem_for(shots_[k], model_of(k), chain), points);
    for (std::size_t i = 0; i < model.size(); ++i)
      residuals.push_back((reported(model[i], chain) - reference[i]) / sigma);
    take_out_correlation(shot->noise, last_of(residuals, model.size()));
  }
  return residuals;
}

ResidualsWithJacobian ForceDeflectionResiduals::with_jacobian(
    const ModelOfShot& model_of, const ErrorsOfShot& errors_of,
    const UnknownsOfShot& unknowns_of) const {
  ResidualsWithJacobian all;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const auto& [shot, points, reference, sigma] = shots_[k];
    const MeasurementChain chain = errors_of ? errors_of(k) : MeasurementChain{};
    const ShotUnknowns unknowns = unknowns_of(k);
    const auto by = directions_of(unknowns);
    const ForcesWithSensitivities model =
        forces_with_sensitivities_at(problem_for(shots_[k], model_of(k), chain), points, by);
    all.residuals.reserve(all.residuals.size() + model.force.size());
    all.slopes.reserve(all.slopes.size() + model.force.size() * unknowns.count);
    for (std::size_t i = 0; i < model.force.size(); ++i) {
      all.residuals.push_back((reported(model.force[i], chain) - reference[i]) / sigma);
      add_row(unknowns,
              {.force = model.force[i],
               .slopes = {&model.slopes[i * by.size()], by.size()},
               .speed = shot->impact.speed,
               .mass = shot->sphere.mass,
               .sigma = sigma},
              chain, all.slopes);
    }
    take_out_correlation(shot->noise, last_of(all.residuals, model.force.size()));
    take_out_correlation(shot->noise, last_of(all.slopes, model.force.size() * unknowns.count),
                         unknowns.count);
  }
  return all;
}

}  // namespace rebound
