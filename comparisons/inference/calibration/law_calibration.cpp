#include "comparisons/inference/calibration/law_calibration.hpp"

#include <cmath>

#include "comparisons/inference/calibration/force_deflection_residuals.hpp"
#include "comparisons/inference/calibration/force_time_residuals.hpp"
#include "comparisons/inference/calibration/law_unknowns.hpp"
#include "comparisons/inference/calibration/reference_checks.hpp"
#include "comparisons/inference/calibration/scalar_residuals.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// Parameters that belong to one speed; repeated shots at a speed share their
/// mean, since a law can have one value there only.
class PerSpeed {
 public:
  void add(double speed, const ParameterValues& values) {
    for (auto& [entry, count] : entries_) {
      if (std::abs(entry.speed - speed) > 1e-6 * speed) continue;
      ++count;
      for (auto& [name, mean] : entry.parameters) mean += (values.at(name) - mean) / count;
      return;
    }
    entries_.push_back({{speed, values}, 1});
  }
  std::vector<ParametersAtSpeed> list() const {
    std::vector<ParametersAtSpeed> all;
    for (const auto& [entry, count] : entries_) all.push_back(entry);
    return all;
  }

 private:
  std::vector<std::pair<ParametersAtSpeed, int>> entries_;
};

/// Restitution of 1 or more leaves nothing to damp, and is a fault of the data.
void check_for_formula(const std::vector<MeasuredImpact>& shots,
                       const LawCalibrationOptions& options) {
  if (options.observable != Observable::force_deflection || options.nuisances.any())
    throw Error(
        ExitCode::bad_input,
        "a damping formula is fitted to force over deflection, without nuisances",
        {.key = "damping_formula", .value = "", .allowed = "leave out observable and nuisance"});
  for (const auto& shot : shots)
    if (!(shot.scalars.restitution > 0.0 && shot.scalars.restitution < 1.0))
      throw Error(ExitCode::bad_input, "a damping formula needs restitutions between 0 and 1",
                  {.key = "restitution",
                   .value = std::to_string(shot.scalars.restitution),
                   .allowed = "0 < e < 1"});
}

}  // namespace

LawCalibration calibrate_hunt_crossley(const std::vector<MeasuredImpact>& shots,
                                       const std::string& damping_formula,
                                       const LawCalibrationOptions& options,
                                       const RunControl& control) {
  const ForceDeflectionResiduals residuals(shots, options);
  check_for_formula(shots, options);
  const auto model_at = [&](double stiffness, std::size_t i) {
    LumpedModel model;
    model.law = "hunt-crossley";
    model.parameters = {{"stiffness", stiffness}};
    model.restitution = shots[i].scalars.restitution;
    model.damping_formula = damping_formula;
    return model;
  };
  const ParameterCard& card = card_of(find_law("hunt-crossley"), "stiffness");
  CalibrationProblem problem;
  problem.parameters = {law_unknown(card, {}, fastest(shots))};
  problem.residuals = [&](const std::vector<double>& x) {
    return residuals([&](std::size_t i) { return model_at(x[0], i); });
  };
  // The damping is in proportion to the stiffness, whatever the formula.
  problem.with_jacobian = [&](const std::vector<double>& x) {
    const auto model_of = [&](std::size_t i) { return model_at(x[0], i); };
    return residuals.with_jacobian(model_of, {}, [&](std::size_t i) {
      const auto values = resolve_parameters(model_of(i), shots[i].impact, shots[i].sphere);
      ShotUnknowns unknowns{.law = {}, .nuisances = {}, .count = 1};
      unknowns.law.add(direction_of("hunt-crossley", "stiffness"), 0);
      unknowns.law.add(direction_of("hunt-crossley", "damping"), 0, values.at("damping") / x[0]);
      return unknowns;
    });
  };
  problem.noise = residuals.noise();
  problem.controls = options.controls;

  LawCalibration calibration;
  calibration.fit = calibrate(problem, control);
  calibration.model.law = "hunt-crossley";
  const double stiffness = calibration.fit.estimates[0].value;
  calibration.model.parameters = {{"exponent", 1.5}, {"stiffness", stiffness}};
  PerSpeed damping;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const auto values =
        resolve_parameters(model_at(stiffness, i), shots[i].impact, shots[i].sphere);
    damping.add(shots[i].impact.speed, {{"damping", values.at("damping")}});
  }
  calibration.model.at_speed = damping.list();
  return calibration;
}

LumpedModel linearise_at_mean_deflection(const LumpedModel& hunt_crossley,
                                         const std::vector<MeasuredImpact>& shots) {
  LumpedModel model;
  model.law = "equivalent-kelvin-voigt";
  PerSpeed linear;
  for (const auto& shot : shots) {
    const auto values = resolve_parameters(hunt_crossley, shot.impact, shot.sphere);
    model.parameters["exponent"] = values.at("exponent");
    model.parameters["stiffness"] = values.at("stiffness");
    linear.add(shot.impact.speed, {{"damping", values.at("damping")},
                                   {"representative_deflection", shot.scalars.mean_deflection}});
  }
  model.at_speed = linear.list();
  return model;
}

namespace {

/// Some errors do not show in a curve that has no clock.
void check_for_deflection(const Nuisances& nuisances) {
  for (const NuisanceKind& kind : all_nuisances())
    if (kind.asked.over_time_only && nuisances.of(kind.name) > 0.0)
      throw Error(
          ExitCode::bad_input, "the nuisance '" + kind.name + "' shows in force over time only",
          {.key = "nuisance." + kind.name, .value = "", .allowed = "observable = \"force-time\""});
}

LawCalibration calibrate_unknowns(const LawUnknowns& law, const std::vector<MeasuredImpact>& shots,
                                  const LawCalibrationOptions& options, const RunControl& control) {
  const bool over_time = options.observable == Observable::force_time;
  if (!over_time) check_for_deflection(options.nuisances);
  CalibrationProblem problem;
  problem.parameters = law.parameters();
  NuisanceUnknowns nuisances(shots.size());
  nuisances.add_asked(options.nuisances, problem.parameters);
  problem.controls = options.controls;
  const auto solve = [&](const auto& residuals) {
    problem.noise = residuals.noise();
    const auto model_at = [&](const std::vector<double>& x) {
      return [&](std::size_t i) { return law.model_for(x, i); };
    };
    const auto errors_at = [&](const std::vector<double>& x) {
      return [&](std::size_t i) {
        MeasurementChain chain;
        nuisances.apply(x, i, chain);
        return chain;
      };
    };
    problem.residuals = [&](const std::vector<double>& x) {
      return residuals(model_at(x), errors_at(x));
    };
    // A law with a state of its own has no slopes to offer.
    if (!has_branch(law.name()))
      problem.with_jacobian = [&](const std::vector<double>& x) {
        return residuals.with_jacobian(model_at(x), errors_at(x), [&](std::size_t i) {
          return ShotUnknowns{
              .law = law.slopes_for(i), .nuisances = nuisances.places(i), .count = x.size()};
        });
      };
    return calibrate(problem, control);
  };
  LawCalibration calibration;
  calibration.fit = over_time ? solve(ForceTimeResiduals(shots, options))
                              : solve(ForceDeflectionResiduals(shots, options));
  calibration.model = law.model(calibration.fit.values());
  return calibration;
}

/// Shots are looked at before unknowns are guessed from them.
void check_shots(const std::vector<MeasuredImpact>& shots) {
  noise_of(shots);
  for (const auto& shot : shots) check_reference(shot);
}

}  // namespace

LawCalibration calibrate_law(const std::string& law, const std::vector<MeasuredImpact>& shots,
                             const ParameterValues& fixed,
                             const std::vector<std::string>& also_free,
                             const LawCalibrationOptions& options, const RunControl& control) {
  return calibrate(
      {.law = law, .damping_formula = {}, .fixed = fixed, .free = also_free, .per_speed = {}},
      shots, options, control);
}

LawCalibration calibrate(const LawRequest& request, const std::vector<MeasuredImpact>& shots,
                         const LawCalibrationOptions& options, const RunControl& control) {
  if (request.damping_formula.empty() && options.observable == Observable::scalars)
    return calibrate_to_scalars(request, shots, options, control);
  if (request.damping_formula.empty()) {
    check_shots(shots);
    return calibrate_unknowns(
        LawUnknowns(
            request.law, shots,
            {.fixed = request.fixed, .also_free = request.free, .per_speed = request.per_speed}),
        shots, options, control);
  }
  const bool equivalent = request.law == "equivalent-kelvin-voigt";
  if (!equivalent && request.law != "hunt-crossley")
    throw Error(ExitCode::bad_input,
                "a damping formula calibrates hunt-crossley or equivalent-kelvin-voigt only",
                {.key = "damping_formula",
                 .value = request.damping_formula,
                 .allowed = "leave it out, or another law"});
  if (!request.fixed.empty() || !request.free.empty() || !request.per_speed.empty())
    throw Error(ExitCode::bad_input,
                "with a damping formula only the stiffness is fitted; nothing else may be fixed "
                "or free",
                {.key = "damping_formula",
                 .value = request.damping_formula,
                 .allowed = "leave out fixed, free and per_speed, or the formula"});
  LawCalibration calibration =
      calibrate_hunt_crossley(shots, request.damping_formula, options, control);
  if (equivalent) calibration.model = linearise_at_mean_deflection(calibration.model, shots);
  return calibration;
}

}  // namespace rebound
