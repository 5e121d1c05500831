#include "lumped/laws/make_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lumped/problem/error.hpp"
#include "lumped/problem/validity.hpp"

namespace rebound {

namespace {

constexpr KeyPath model_path{"model"};
constexpr double same_speed = 1e-6;  // relative; a speed that went through TOML and units

Error bad(const std::string& message, const std::string& key, const std::string& value,
          const std::string& allowed) {
  return {ExitCode::bad_input, message, {.key = key, .value = value, .allowed = allowed}};
}

void require_known(const LawCard& card, const ParameterValues& values, const KeyPath& at) {
  for (const auto& [name, value] : values) {
    const auto same = [&wanted = name](const ParameterCard& p) { return p.name == wanted; };
    if (std::any_of(card.parameters.begin(), card.parameters.end(), same)) continue;
    std::string names;
    for (const auto& p : card.parameters) names += (names.empty() ? "" : ", ") + p.name;
    throw bad("law '" + card.name + "' has no parameter '" + name + "'", at.of(name),
              number_text(value), names);
  }
}

/// `values` holds the parameters that set the dimension of this one.
void require_in_range(const ParameterCard& card, double value, const ParameterValues& values,
                      const KeyPath& at) {
  if (!card.range.contains(value))
    refuse_value(at.of(card.name), value,
                 allowed_text(card.range, unit_name(card.dimension(values))));
}

/// Those of `values` that are given; `others` may set their dimensions.
void require_all_in_range(const LawCard& card, const ParameterValues& values,
                          const ParameterValues& others, const KeyPath& at) {
  for (const auto& parameter : card.parameters) {
    const auto found = values.find(parameter.name);
    if (found == values.end() || parameter.range.contains(found->second)) continue;
    ParameterValues all = values;
    all.insert(others.begin(), others.end());
    require_in_range(parameter, found->second, all, at);
  }
}

/// The at_speed entry that applies, or nullptr.
const ParametersAtSpeed* entry_for(const LumpedModel& model, const LawCard& card, double speed) {
  const ParametersAtSpeed* found = nullptr;
  for (std::size_t i = 0; i < model.at_speed.size(); ++i) {
    const ParametersAtSpeed& entry = model.at_speed[i];
    const KeyPath at{"at_speed", static_cast<int>(i), &model_path};
    require_limits(entry, at);
    require_known(card, entry.parameters, at);
    require_all_in_range(card, entry.parameters, model.parameters, at);
    if (std::abs(entry.speed - speed) > same_speed * speed) continue;
    if (found)
      throw bad("two at_speed entries for one speed", at.of("speed"), number_text(entry.speed),
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
              "model.restitution", model.restitution ? number_text(*model.restitution) : "",
              "laws with a damping formula");
  if (!model.restitution)
    throw bad("a damping formula needs the restitution it is to return", "model.restitution", "",
              allowed_text(limit_of<&LumpedModel::restitution>.range, ""));
  if (!formula)
    throw bad("a restitution needs the damping formula that turns it into damping",
              "model.damping_formula", "", "for example exact");
  if (model.parameters.contains(card.damping_parameter))
    throw bad("damping is given twice: directly and by a restitution",
              "model." + card.damping_parameter,
              number_text(model.parameters.at(card.damping_parameter)), "one of the two");
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
  require_limits(sphere, {"sphere"});
  require_limits(impact, {"impact"});
  require_limits(model, model_path);
  require_known(card, model.parameters, model_path);
  require_all_in_range(card, model.parameters, {}, model_path);
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
                    number_text(impact.speed) + " m/s",
                "model." + parameter.name, "",
                "give it under [model], or in an at_speed entry for this speed");
    }
  }
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
      if (parameter.name == card.damping_parameter)
        require_in_range(parameter, damping, values, model_path);
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
