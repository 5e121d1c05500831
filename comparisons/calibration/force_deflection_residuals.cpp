#include "comparisons/calibration/force_deflection_residuals.hpp"

#include <algorithm>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

void check(const Trace& trace) {
  if (trace.time.size() < 5 || trace.force.size() != trace.time.size() ||
      trace.deflection.size() != trace.time.size())
    throw Error(ExitCode::bad_input,
                "a calibration needs force and deflection at five instants or more");
  const auto peak = [](const auto& values) { return *std::max_element(values.begin(), values.end()); };
  if (!(peak(trace.force) > 0.0) || !(peak(trace.deflection) > 0.0))
    throw Error(ExitCode::bad_input, "a reference trace has no force or no deflection");
}

}  // namespace

ForceDeflectionResiduals::ForceDeflectionResiduals(const std::vector<ReferenceShot>& shots,
                                                   const LawCalibrationOptions& options) {
  if (shots.empty()) throw Error(ExitCode::bad_input, "a calibration needs at least one trace");
  for (const auto& shot : shots)
    if (!(shot.force_uncertainty > 0.0)) noise_ = NoiseKnowledge::estimated;
  for (const auto& shot : shots) {
    check(shot.trace);
    const double peak_force = *std::max_element(shot.trace.force.begin(), shot.trace.force.end());
    const double sigma = noise_ == NoiseKnowledge::known            ? shot.force_uncertainty
                         : options.weighting == Weighting::of_peak ? peak_force
                                                                   : 1.0;
    Prepared prepared{&shot, {}, {}, sigma};
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

std::vector<double> ForceDeflectionResiduals::operator()(
    const std::function<LumpedModel(std::size_t)>& model_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const auto& [shot, points, reference, sigma] = shots_[k];
    const std::vector<double> model = forces_at(
        {.sphere = shot->sphere, .impact = shot->impact, .model = model_of(k), .controls = {}},
        points);
    for (std::size_t i = 0; i < model.size(); ++i)
      residuals.push_back((model[i] - reference[i]) / sigma);
  }
  return residuals;
}

}  // namespace rebound
