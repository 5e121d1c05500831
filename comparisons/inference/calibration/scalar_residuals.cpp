#include "comparisons/inference/calibration/scalar_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "comparisons/inference/calibration/law_unknowns.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::optional<double> contact_time_of(const MeasuredImpact& shot, double impulse,
                                      const std::string& law, const ParameterValues& fixed) {
  if (shot.contact_time.value) return *shot.contact_time.value;
  if (shot.peak_force.value) return 0.5 * std::numbers::pi * impulse / *shot.peak_force.value;
  const auto stiffness = fixed.find("stiffness");
  if (stiffness == fixed.end()) return std::nullopt;
  constexpr double hertz_contact_time = 2.9432;  // times x/v; π for a linear spring
  const ParameterCard& card = card_of(find_law(law), "stiffness");
  ParameterValues values = fixed;
  for (const ParameterCard& other : find_law(law).parameters)
    if (other.default_value) values.try_emplace(other.name, *other.default_value);
  const double n = 1.0 - card.dimension(values).metre;  // N/m^n
  const double v = shot.impact.speed;
  const double x =
      std::pow(0.5 * (n + 1.0) * shot.sphere.mass * v * v / stiffness->second, 1.0 / (n + 1.0));
  return hertz_contact_time * x / v;
}

double modelled(const ScalarQuantity& scalar, const LumpedResult& result,
                const MeasuredImpact& shot) {
  if (scalar.what == ObservedQuantity::contact_time)
    return reported_contact_time(result.trace, result.scalars.contact_time,
                                 shot.contact_threshold.value_or(0.0));
  return result.scalars.*scalar.modelled;
}

}  // namespace

ScalarResiduals::ScalarResiduals(const std::vector<MeasuredImpact>& shots) : shots_(shots) {
  if (shots.empty()) throw Error(ExitCode::bad_input, "a calibration needs at least one shot");
  for (const MeasuredImpact& shot : shots)
    if (std::none_of(scalar_quantities.begin(), scalar_quantities.end(),
                     [&](const ScalarQuantity& one) { return (shot.*one.measured).has_error(); }))
      throw Error(ExitCode::bad_input,
                  "a shot has no scalar that states its uncertainty: " + shot.label,
                  {.key = "shot", .value = "", .allowed = "restitution_uncertainty and the like"});
}

std::vector<double> ScalarResiduals::operator()(const ModelOfShot& model_of) const {
  std::vector<double> residuals;
  for (std::size_t k = 0; k < shots_.size(); ++k) {
    const MeasuredImpact& shot = shots_[k];
    const LumpedResult result = simulate_fast({.sphere = shot.sphere,
                                               .impact = shot.impact,
                                               .model = model_of(k),
                                               .controls = {.relative_tolerance = fit_tolerance}});
    for (const ScalarQuantity& scalar : scalar_quantities)
      if (const Measured& stated = shot.*scalar.measured; stated.has_error())
        residuals.push_back((modelled(scalar, result, shot) - *stated.value) / *stated.uncertainty);
  }
  return residuals;
}

std::vector<MeasuredImpact> with_guessed_records(const std::vector<MeasuredImpact>& shots,
                                                 const std::string& law,
                                                 const ParameterValues& fixed) {
  std::vector<MeasuredImpact> guessed = shots;
  for (MeasuredImpact& shot : guessed) {
    const double impulse =
        shot.sphere.mass * shot.impact.speed * (1.0 + shot.restitution.value.value_or(0.5));
    const auto duration = contact_time_of(shot, impulse, law, fixed);
    if (!duration)
      throw Error(ExitCode::bad_input,
                  "nothing tells the stiffness: restitutions alone do not, contact times or peak "
                  "forces would",
                  {.key = "fixed.stiffness", .value = "", .allowed = "a fixed stiffness"});
    constexpr int samples = 21;
    shot.trace = {};
    for (int i = 0; i < samples; ++i) {
      const double share = i / (samples - 1.0), wave = std::sin(std::numbers::pi * share);
      shot.trace.time.push_back(share * *duration);
      shot.trace.force.push_back(0.5 * std::numbers::pi * impulse / *duration * wave);
      shot.trace.deflection.push_back(shot.impact.speed * *duration / std::numbers::pi * wave);
    }
  }
  return guessed;
}

LawCalibration calibrate_to_scalars(const LawRequest& request,
                                    const std::vector<MeasuredImpact>& shots,
                                    const LawCalibrationOptions& options,
                                    const RunControl& control) {
  if (options.nuisances.any())
    throw Error(ExitCode::bad_input, "nuisances belong to a record of the force",
                {.key = "nuisance", .value = "", .allowed = "none with observable = \"scalars\""});
  const ScalarResiduals residuals(shots);
  const LawUnknowns law(
      request.law, with_guessed_records(shots, request.law, request.fixed),
      {.fixed = request.fixed, .also_free = request.free, .per_speed = request.per_speed});
  CalibrationProblem problem;
  problem.parameters = law.parameters();
  problem.controls = options.controls;
  problem.noise = NoiseKnowledge::known;
  problem.residuals = [&](const std::vector<double>& x) {
    return residuals([&](std::size_t i) { return law.model_for(x, i); });
  };
  LawCalibration calibration;
  calibration.fit = calibrate(problem, control);
  calibration.model = law.model(calibration.fit.values());
  return calibration;
}

}  // namespace rebound
