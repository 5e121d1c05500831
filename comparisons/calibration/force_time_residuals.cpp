#include "comparisons/calibration/force_time_residuals.hpp"

#include "comparisons/calibration/reference_checks.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {

namespace {

constexpr int samples = 1001;

double force_at(const Trace& trace, double time) {
  const double duration = trace.time.back();
  if (!(time >= 0.0) || time > duration) return 0.0;
  const double at = time / duration * static_cast<double>(samples - 1);
  const auto low = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(samples - 2));
  const double share = at - static_cast<double>(low);
  return trace.force[low] + share * (trace.force[low + 1] - trace.force[low]);
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

std::vector<double> ForceTimeResiduals::operator()(const ModelOfShot& model_of,
                                                   const ErrorsOfShot& errors_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const ReferenceShot& shot = shots_[k];
    const RecordErrors errors = errors_of(k);
    LumpedProblem problem{.sphere = shot.sphere, .impact = shot.impact, .model = model_of(k),
                          .controls = {.samples = samples}};
    problem.impact.speed *= errors.speed_factor;
    const LumpedResult run = simulate_fast(problem);
    for (std::size_t i = 0; i < shot.trace.time.size(); ++i) {
      const double model =
          errors.gain * force_at(run.trace, shot.trace.time[i] - errors.trigger) + errors.baseline;
      residuals.push_back((model - shot.trace.force[i]) / sigma_[k]);
    }
  }
  return residuals;
}

}  // namespace rebound
