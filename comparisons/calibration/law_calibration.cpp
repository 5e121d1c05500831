#include "comparisons/calibration/law_calibration.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/calibration/force_deflection_residuals.hpp"
#include "comparisons/config/units.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

double peak_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

const ParameterCard& card_of(const LawCard& law, const std::string& name) {
  for (const auto& p : law.parameters)
    if (p.name == name) return p;
  throw Error(ExitCode::bad_input, "law '" + law.name + "' has no parameter '" + name + "'",
              {.key = name, .value = "", .allowed = "a parameter of the law"});
}

/// First guess from the fastest trace by dimension: force is counted in its
/// peak, length in its peak deflection, speed in its approach speed.
double guess_of(const ParameterCard& card, const ParameterValues& values,
                const ReferenceShot& shot) {
  if (card.default_value) return *card.default_value;
  const Dimension d = card.dimension(values);
  if (d == dimension::none) return 0.5;
  const double force = peak_of(shot.trace.force), x = peak_of(shot.trace.deflection);
  // kg m/s² to the power a, m to the power b, m/s to the power c.
  const double a = d.kilogram, c = -(d.second + 2.0 * a), b = d.metre - a - c;
  const double size = std::pow(force, a) * std::pow(x, b) * std::pow(shot.impact.speed, c);
  return c == 0.0 ? size : size / 3.0;
}

/// Bounds four decades around the guess, within the card's range.
CalibrationParameter unknown(const ParameterCard& card, const ParameterValues& values,
                             double guess) {
  const bool number = card.dimension(values) == dimension::none;
  CalibrationParameter p{.name = card.name, .unit = unit_name(card.dimension(values)),
                         .start = guess,
                         .lowest = number ? card.lowest : guess * 1e-4,
                         .highest = number ? card.highest : guess * 1e4,
                         .scale = guess};
  if (number && !card.lowest_allowed) p.lowest += 1e-3;
  return p;
}

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

const ReferenceShot& fastest(const std::vector<ReferenceShot>& shots) {
  return *std::max_element(shots.begin(), shots.end(), [](const auto& a, const auto& b) {
    return a.impact.speed < b.impact.speed;
  });
}

}  // namespace

LawCalibration calibrate_hunt_crossley(const std::vector<ReferenceShot>& shots,
                                       const std::string& damping_formula,
                                       const LawCalibrationOptions& options,
                                       const RunControl& control) {
  const ForceDeflectionResiduals residuals(shots, options);
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
  problem.parameters = {unknown(card, {}, guess_of(card, {}, fastest(shots)))};
  problem.residuals = [&](const std::vector<double>& x) {
    return residuals([&](std::size_t i) { return model_at(x[0], i); });
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
                                         const std::vector<ReferenceShot>& shots) {
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

LawCalibration calibrate_law(const std::string& law, const std::vector<ReferenceShot>& shots,
                             const ParameterValues& fixed,
                             const std::vector<std::string>& also_free,
                             const LawCalibrationOptions& options, const RunControl& control) {
  const ForceDeflectionResiduals residuals(shots, options);
  const LawCard& card = find_law(law);
  for (const auto& [name, value] : fixed) card_of(card, name);
  for (const auto& name : also_free) card_of(card, name);
  CalibrationProblem problem;
  ParameterValues values = fixed;
  for (const auto& p : card.parameters) {
    const bool named = std::find(also_free.begin(), also_free.end(), p.name) != also_free.end();
    if (fixed.contains(p.name) || (p.default_value && !named)) continue;
    values[p.name] = guess_of(p, values, fastest(shots));
    problem.parameters.push_back(unknown(p, values, values[p.name]));
  }
  if (problem.parameters.empty())
    throw Error(ExitCode::bad_input, "every parameter of '" + law + "' is fixed: nothing to fit");

  LawCalibration calibration;
  calibration.model.law = law;
  const auto model_of = [&](const std::vector<double>& x) {
    LumpedModel model;
    model.law = law;
    model.parameters = fixed;
    for (std::size_t i = 0; i < x.size(); ++i)
      model.parameters[problem.parameters[i].name] = x[i];
    return model;
  };
  problem.residuals = [&](const std::vector<double>& x) {
    const LumpedModel model = model_of(x);
    return residuals([&](std::size_t) { return model; });
  };
  problem.noise = residuals.noise();
  problem.controls = options.controls;
  calibration.fit = calibrate(problem, control);
  std::vector<double> estimates;
  for (const auto& e : calibration.fit.estimates) estimates.push_back(e.value);
  calibration.model = model_of(estimates);
  return calibration;
}

LawCalibration calibrate(const LawRequest& request, const std::vector<ReferenceShot>& shots,
                         const LawCalibrationOptions& options, const RunControl& control) {
  if (request.damping_formula.empty())
    return calibrate_law(request.law, shots, request.fixed, request.free, options, control);
  const bool equivalent = request.law == "equivalent-kelvin-voigt";
  if (!equivalent && request.law != "hunt-crossley")
    throw Error(ExitCode::bad_input,
                "a damping formula calibrates hunt-crossley or equivalent-kelvin-voigt only",
                {.key = "damping_formula", .value = request.damping_formula,
                 .allowed = "leave it out, or another law"});
  if (!request.fixed.empty() || !request.free.empty())
    throw Error(ExitCode::bad_input,
                "with a damping formula only the stiffness is fitted; nothing else may be fixed "
                "or free",
                {.key = "damping_formula", .value = request.damping_formula,
                 .allowed = "leave out fixed and free, or the formula"});
  LawCalibration calibration =
      calibrate_hunt_crossley(shots, request.damping_formula, options, control);
  if (equivalent) calibration.model = linearise_at_mean_deflection(calibration.model, shots);
  return calibration;
}

}  // namespace rebound
