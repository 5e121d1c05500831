#include "comparisons/calibration/force_time_residuals.hpp"

#include "comparisons/calibration/reference_checks.hpp"
#include "comparisons/calibration/residual_slopes.hpp"
#include "lumped/integration/force_time.hpp"

namespace rebound {

namespace {

std::vector<double> shifted(std::vector<double> time, double trigger) {
  for (double& t : time) t -= trigger;
  return time;
}

}  // namespace

ForceTimeResiduals::ForceTimeResiduals(const std::vector<ReferenceShot>& shots,
                                       const LawCalibrationOptions& options)
    : shots_(shots), noise_(noise_of(shots)) {
  for (const auto& shot : shots) {
    check_reference(shot);
    sigma_.push_back(weight_of(shot, noise_, options.weighting));
  }
}

LumpedProblem ForceTimeResiduals::problem_for(std::size_t shot, const LumpedModel& model,
                                              const RecordErrors& errors) const {
  LumpedProblem problem{.sphere = shots_[shot].sphere, .impact = shots_[shot].impact,
                        .model = model, .controls = {.relative_tolerance = fit_tolerance}};
  problem.impact.speed *= errors.speed_factor;
  return problem;
}

std::vector<double> ForceTimeResiduals::operator()(const ModelOfShot& model_of,
                                                   const ErrorsOfShot& errors_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const RecordErrors errors = errors_of(k);
    const TimedForces model = forces_at_instants(problem_for(k, model_of(k), errors),
                                                 shifted(shots_[k].trace.time, errors.trigger));
    for (std::size_t i = 0; i < model.force.size(); ++i)
      residuals.push_back(
          (errors.gain * model.force[i] + errors.baseline - shots_[k].trace.force[i]) / sigma_[k]);
  }
  return residuals;
}

VariedResiduals ForceTimeResiduals::varied(const ModelOfShot& model_of,
                                           const ErrorsOfShot& errors_of,
                                           const UnknownsOfShot& unknowns_of) const {
  VariedResiduals all;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const RecordErrors errors = errors_of(k);
    const ShotUnknowns unknowns = unknowns_of(k);
    const auto by = directions_of(unknowns);
    const TimedForces model = forces_at_instants(problem_for(k, model_of(k), errors),
                                                 shifted(shots_[k].trace.time, errors.trigger), by);
    all.residuals.reserve(all.residuals.size() + model.force.size());
    all.slopes.reserve(all.slopes.size() + model.force.size() * unknowns.count);
    for (std::size_t i = 0; i < model.force.size(); ++i) {
      all.residuals.push_back(
          (errors.gain * model.force[i] + errors.baseline - shots_[k].trace.force[i]) / sigma_[k]);
      add_row(unknowns,
              {.force = model.force[i], .slopes = {&model.slopes[i * by.size()], by.size()},
               .rate = model.rate[i], .speed = shots_[k].impact.speed, .sigma = sigma_[k]},
              errors, all.slopes);
    }
  }
  return all;
}

}  // namespace rebound
