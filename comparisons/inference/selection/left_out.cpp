#include "comparisons/inference/selection/left_out.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/scalar_residuals.hpp"
#include "comparisons/inference/references/law_score.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

bool equal_speeds(double a, double b) {
  return std::abs(a - b) <= 1e-6 * b;
}

std::vector<double> speeds_of(const std::vector<MeasuredImpact>& references) {
  std::vector<double> speeds;
  for (const auto& r : references) {
    const double v = r.impact.speed;
    if (std::none_of(speeds.begin(), speeds.end(), [&](double s) { return equal_speeds(s, v); }))
      speeds.push_back(v);
  }
  return speeds;
}

LeftOut predicted(const Candidate& candidate, const std::vector<MeasuredImpact>& references,
                  double speed, const LawCalibrationOptions& options, const RunControl& control) {
  LeftOut out{.speed = speed, .failure = {}};
  std::vector<MeasuredImpact> others;
  std::vector<MeasuredImpact> held;
  for (const auto& r : references) {
    if (equal_speeds(r.impact.speed, speed))
      held.push_back(r);
    else
      others.push_back(r);
  }
  try {
    const LumpedModel model = calibrate(candidate.request, others, options, control).model;
    double square = 0.0;
    if (options.observable == Observable::scalars) {
      const auto residuals =
          ScalarResiduals(held)([&](std::size_t) -> const LumpedModel& { return model; });
      for (const double residual : residuals) square += residual * residual;
      out.force_rms = std::sqrt(square / static_cast<double>(residuals.size()));
      return out;
    }
    for (const MeasuredImpact& reference : held) {
      check_scorable(reference);
      const LawScore cell = score_law(model, reference);
      if (!cell.failure.empty()) throw Error(ExitCode::solver_failed, cell.failure);
      square += cell.force_time_rms * cell.force_time_rms;
      out.restitution_error +=
          cell.against_reference.restitution.value_or(0.0) * reference.scalars.restitution;
      out.contact_time_error += cell.against_reference.contact_time.value_or(0.0);
    }
    const auto count = static_cast<double>(held.size());
    out.force_rms = std::sqrt(square / count);
    out.restitution_error /= count;
    out.contact_time_error /= count;
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    out.failure = error.what();
  }
  return out;
}

}  // namespace

void predict_left_out(const Candidate& candidate, const std::vector<MeasuredImpact>& references,
                      const LawCalibrationOptions& options, const RunControl& control,
                      CandidateScore& score) {
  const std::vector<double> speeds = speeds_of(references);
  if (speeds.size() < 2) return;
  LawCalibrationOptions without_checkpoint = options;
  without_checkpoint.controls.checkpoint.clear();  // belongs to the fit to everything
  double square = 0.0;
  bool all = true;
  for (double speed : speeds) {
    score.left_out.push_back(predicted(candidate, references, speed, without_checkpoint, control));
    square += score.left_out.back().force_rms * score.left_out.back().force_rms;
    all = all && score.left_out.back().failure.empty();
  }
  if (all) score.prediction_error = std::sqrt(square / static_cast<double>(speeds.size()));
}

}  // namespace rebound
