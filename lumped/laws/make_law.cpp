#include "lumped/laws/make_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr double same_speed = 1e-6;  // relative; a speed that went through TOML and units

std::string text(double value) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << value;
  return out.str();
}

Error bad(const std::string& message, const std::string& key, const std::string& value,
          const std::string& allowed) {
  return {ExitCode::bad_input, message, {.key = key, .value = value, .allowed = allowed}};
}

void require_positive(double value, const std::string& key) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw bad(key + " must be positive and finite", key, text(value), "> 0");
}

void require_known(const LawCard& card, const ParameterValues& values) {
  for (const auto& [name, value] : values) {
    const auto same = [&](const ParameterCard& p) { return p.name == name; };
    if (std::any_of(card.parameters.begin(), card.parameters.end(), same)) continue;
    std::string names;
    for (const auto& p : card.parameters) names += (names.empty() ? "" : ", ") + p.name;
    throw bad("law '" + card.name + "' has no parameter '" + name + "'", "model." + name,
              text(value), names);
  }
}

void require_in_range(const ParameterCard& card, double value) {
  const bool above = card.lowest_allowed ? value >= card.lowest : value > card.lowest;
  if (above && value <= card.highest) return;  // false for NaN as well
  const std::string range = (card.lowest_allowed ? "[" : "(") + text(card.lowest) + ", " +
                            text(card.highest) + "] in SI units";
  throw bad("'" + card.name + "' is out of range", "model." + card.name, text(value), range);
}

/// The at_speed entry that applies, or nullptr.
const ParametersAtSpeed* entry_for(const LumpedModel& model, const LawCard& card, double speed) {
  const ParametersAtSpeed* found = nullptr;
  for (const auto& entry : model.at_speed) {
    require_positive(entry.speed, "model.at_speed.speed");
    require_known(card, entry.parameters);
    if (std::abs(entry.speed - speed) > same_speed * speed) continue;
    if (found)
      throw bad("two at_speed entries for one speed", "model.at_speed.speed", text(entry.speed),
                "one entry a speed");
    found = &entry;
  }
  return found;
}

void check_damping_given_once(const LumpedModel& model, const LawCard& card) {
  const bool formula = !model.damping_formula.empty();
  if (!model.restitution && !formula) return;
  if (card.damping_parameter.empty())
    throw bad("law '" + card.name + "' has no damping formula: give its damping",
              "model.restitution", model.restitution ? text(*model.restitution) : "",
              "laws with a damping formula");
  if (!model.restitution)
    throw bad("a damping formula needs the restitution it is to return", "model.restitution", "",
              "0 < e <= 1");
  if (!formula)
    throw bad("a restitution needs the damping formula that turns it into damping",
              "model.damping_formula", "", "for example exact");
  if (model.parameters.contains(card.damping_parameter))
    throw bad("damping is given twice: directly and by a restitution",
              "model." + card.damping_parameter,
              text(model.parameters.at(card.damping_parameter)), "one of the two");
}

double damping_by_formula(const LawCard& card, const DampingRequest& request) {
  double damping = std::numeric_limits<double>::quiet_NaN();
  for_law(card.name, [&]<class Law>() {
    if constexpr (requires { Law::damping_for(request); }) damping = Law::damping_for(request);
  });
  return damping;
}

/// What a law takes from the sphere where the user gave nothing.
void complete_from_sphere(const LawCard& card, ParameterValues& values, const Sphere& sphere) {
  for_law(card.name, [&]<class Law>() {
    if constexpr (requires { Law::complete(values, sphere); }) Law::complete(values, sphere);
  });
}

}  // namespace

ParameterValues resolve_parameters(const LumpedModel& model, const Impact& impact,
                                   const Sphere& sphere) {
  const LawCard& card = find_law(model.law);
  require_positive(sphere.mass, "sphere.mass");
  require_positive(impact.speed, "impact.speed");
  require_known(card, model.parameters);
  check_damping_given_once(model, card);

  ParameterValues values = model.parameters;
  if (const auto* entry = entry_for(model, card, impact.speed))
    for (const auto& [name, value] : entry->parameters) values[name] = value;
  for (const auto& parameter : card.parameters) {
    if (values.contains(parameter.name)) continue;
    if (parameter.default_value) {
      values[parameter.name] = *parameter.default_value;
    } else if (!(model.restitution && parameter.name == card.damping_parameter)) {
      throw bad("law '" + card.name + "' needs '" + parameter.name + "' at " +
                    text(impact.speed) + " m/s",
                "model." + parameter.name, "",
                "give it under [model], or in an at_speed entry for this speed");
    }
  }
  for (const auto& parameter : card.parameters)
    if (values.contains(parameter.name)) require_in_range(parameter, values.at(parameter.name));
  complete_from_sphere(card, values, sphere);
  if (model.restitution && !values.contains(card.damping_parameter)) {
    const auto damping_by = [&](const std::string& formula) {
      return damping_by_formula(card, {.formula = formula,
                                       .restitution = *model.restitution,
                                       .mass = sphere.mass,
                                       .impact = impact,
                                       .parameters = values});
    };
    double damping = damping_by(model.damping_formula);
    if (model.exact_damping_share != 0.0)
      damping += model.exact_damping_share * (damping_by("exact") - damping);
    for (const auto& parameter : card.parameters)
      if (parameter.name == card.damping_parameter) require_in_range(parameter, damping);
    values[card.damping_parameter] = damping;
  }
  return values;
}

AnyLaw make_law(const LumpedModel& model, const Impact& impact, const Sphere& sphere) {
  const ParameterValues values = resolve_parameters(model, impact, sphere);
  AnyLaw law;
  for_law(model.law, [&]<class Law>() { law = Law::from(values); });
  return law;
}

}  // namespace rebound
