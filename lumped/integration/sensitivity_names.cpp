#include "lumped/integration/sensitivity_names.hpp"

#include <algorithm>

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/laws/law_card.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

std::vector<std::string> names_of_directions(const std::string& law) {
  std::vector<std::string> names;
  for (const auto& parameter : find_law(law).parameters) names.push_back(parameter.name);
  names.insert(names.end(), {"mass", "speed"});
  return names;
}

std::vector<Direction> all_directions(const std::string& law) {
  std::vector<Direction> all;
  for (const auto& name : names_of_directions(law)) all.push_back(direction_of(law, name));
  return all;
}

Direction direction_of(const std::string& law, const std::string& name) {
  if (name == "mass") return {.of = Direction::Of::mass};
  if (name == "speed") return {.of = Direction::Of::speed};
  const auto& cards = find_law(law).parameters;
  const auto found =
      std::find_if(cards.begin(), cards.end(), [&](const auto& c) { return c.name == name; });
  if (found == cards.end())
    throw Error(ExitCode::bad_input, "law '" + law + "' has no parameter '" + name + "'",
                {.key = name, .value = "", .allowed = "a parameter of the law, mass or speed"});
  return {.of = Direction::Of::law, .parameter = static_cast<std::size_t>(found - cards.begin())};
}

void require_bare(const LumpedProblem& problem) {
  if (!ComposedContact::needed(problem)) return;
  throw Error(ExitCode::bad_input,
              "sensitivities are those of a law alone, without mechanisms or a state of its own",
              {.key = "model",
               .value = problem.model.law,
               .allowed = "a law without memory and no effect"});
}

}  // namespace rebound
