#include "comparisons/calibration/force_deflection_residuals.hpp"

#include <algorithm>

#include "comparisons/calibration/reference_checks.hpp"

namespace rebound {

ForceDeflectionResiduals::ForceDeflectionResiduals(const std::vector<ReferenceShot>& shots,
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

std::vector<double> ForceDeflectionResiduals::operator()(const ModelOfShot& model_of,
                                                         const ErrorsOfShot& errors_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const auto& [shot, points, reference, sigma] = shots_[k];
    const RecordErrors errors = errors_of ? errors_of(k) : RecordErrors{};
    LumpedProblem problem{.sphere = shot->sphere, .impact = shot->impact, .model = model_of(k),
                          .controls = {}};
    problem.impact.speed *= errors.speed_factor;
    const std::vector<double> model = forces_at(problem, points);
    for (std::size_t i = 0; i < model.size(); ++i)
      residuals.push_back((errors.gain * model[i] + errors.baseline - reference[i]) / sigma);
  }
  return residuals;
}

}  // namespace rebound
