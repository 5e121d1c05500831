#include "comparisons/inference/calibration/force_time_residuals.hpp"

#include "comparisons/inference/calibration/reference_checks.hpp"
#include "comparisons/inference/calibration/residual_slopes.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "lumped/integration/force_time.hpp"

namespace rebound {

namespace {

std::vector<double> shifted(std::vector<double> time, double trigger) {
  for (double& t : time) t -= trigger;
  return time;
}

}  // namespace

ForceTimeResiduals::ForceTimeResiduals(const std::vector<MeasuredImpact>& shots,
                                       const LawCalibrationOptions& options)
    : shots_(shots), noise_(noise_of(shots)) {
  for (const auto& shot : shots) {
    check_reference(shot);
    sigma_.push_back(weight_of(shot, noise_, options.weighting));
  }
}

LumpedProblem ForceTimeResiduals::problem_for(std::size_t shot, const LumpedModel& model,
                                              const MeasurementChain& chain) const {
  LumpedProblem problem{.sphere = shots_[shot].sphere,
                        .impact = shots_[shot].impact,
                        .model = model,
                        .controls = {.relative_tolerance = fit_tolerance}};
  problem.sphere.mass /= 1.0 + chain.mass_error;
  problem.impact.speed /= 1.0 + chain.speed_error;
  return problem;
}

std::vector<double> ForceTimeResiduals::operator()(const ModelOfShot& model_of,
                                                   const ErrorsOfShot& errors_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const MeasurementChain chain = errors_of(k);
    const TimedForces model = forces_at_instants(
        problem_for(k, model_of(k), chain), shifted(shots_[k].trace.time, chain.trigger_shift));
    for (std::size_t i = 0; i < model.force.size(); ++i)
      residuals.push_back((reported(model.force[i], chain) - shots_[k].trace.force[i]) / sigma_[k]);
    take_out_correlation(shots_[k].noise, last_of(residuals, model.force.size()));
  }
  return residuals;
}

ResidualsWithJacobian ForceTimeResiduals::with_jacobian(const ModelOfShot& model_of,
                                                        const ErrorsOfShot& errors_of,
                                                        const UnknownsOfShot& unknowns_of) const {
  ResidualsWithJacobian all;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const MeasurementChain chain = errors_of(k);
    const ShotUnknowns unknowns = unknowns_of(k);
    const auto by = directions_of(unknowns);
    const TimedForces model = forces_at_instants(
        problem_for(k, model_of(k), chain), shifted(shots_[k].trace.time, chain.trigger_shift), by);
    all.residuals.reserve(all.residuals.size() + model.force.size());
    all.slopes.reserve(all.slopes.size() + model.force.size() * unknowns.count);
    for (std::size_t i = 0; i < model.force.size(); ++i) {
      all.residuals.push_back((reported(model.force[i], chain) - shots_[k].trace.force[i]) /
                              sigma_[k]);
      add_row(unknowns,
              {.force = model.force[i],
               .slopes = {&model.slopes[i * by.size()], by.size()},
               .rate = model.rate[i],
               .speed = shots_[k].impact.speed,
               .mass = shots_[k].sphere.mass,
               .sigma = sigma_[k]},
              chain, all.slopes);
    }
    take_out_correlation(shots_[k].noise, last_of(all.residuals, model.force.size()));
    take_out_correlation(shots_[k].noise, last_of(all.slopes, model.force.size() * unknowns.count),
                         unknowns.count);
  }
  return all;
}

}  // namespace rebound
