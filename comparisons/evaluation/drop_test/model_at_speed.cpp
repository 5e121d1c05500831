#include "comparisons/evaluation/drop_test/model_at_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lumped/laws/laws.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {
namespace {

bool complete(const LumpedProblem& problem) {
  const auto given = [&](const std::string& name) {
    if (problem.model.parameters.contains(name)) return true;
    return std::any_of(
        problem.model.at_speed.begin(), problem.model.at_speed.end(), [&](const auto& entry) {
          return std::abs(entry.speed - problem.impact.speed) <= 1e-6 * problem.impact.speed &&
                 entry.parameters.contains(name);
        });
  };
  const LawCard& card = find_law(problem.model.law);
  return std::all_of(card.parameters.begin(), card.parameters.end(), [&](const auto& p) {
    return p.default_value || given(p.name) ||
           (p.name == card.damping_parameter && problem.model.restitution);
  });
}

LumpedModel with(const LumpedModel& model, const ParameterValues& values) {
  LumpedModel one = model;
  one.at_speed.clear();
  for (const auto& [name, value] : values) one.parameters[name] = value;
  return one;
}

ParameterValues between(const ParametersAtSpeed& a, const ParametersAtSpeed& b, double speed) {
  const double share = std::log(speed / a.speed) / std::log(b.speed / a.speed);
  ParameterValues values;
  for (const auto& [name, value] : a.parameters)
    if (b.parameters.contains(name)) values[name] = value + share * (b.parameters.at(name) - value);
  return values;
}

}  // namespace

ModelAtSpeed model_at_speed(const LumpedProblem& problem) {
  if (problem.model.at_speed.empty() || complete(problem))
    return {.model = problem.model, .neighbours = {}, .note = {}};
  auto entries = problem.model.at_speed;
  std::sort(entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.speed < b.speed; });
  const double speed = problem.impact.speed;
  const auto above =
      std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.speed >= speed; });
  ModelAtSpeed found;
  if (above == entries.begin() || above == entries.end()) {
    const auto& nearest = above == entries.end() ? entries.back() : entries.front();
    found.model = with(problem.model, nearest.parameters);
    found.note = fmt::format(
        "parameters were fitted speed by speed; those of {:g} m/s are used at {:.3g} m/s",
        nearest.speed, speed);
    return found;
  }
  const auto below = above - 1;
  found.model = with(problem.model, between(*below, *above, speed));
  found.neighbours = {with(problem.model, below->parameters),
                      with(problem.model, above->parameters)};
  found.note = fmt::format(
      "parameters were fitted speed by speed; at {:.3g} m/s they are interpolated between {:g} and "
      "{:g} m/s, and the interval holds what either gives",
      speed, below->speed, above->speed);
  return found;
}

}  // namespace rebound
