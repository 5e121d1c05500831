#pragma once

#include <string>

#include "lumped/laws/law_card.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound::test {

/// Core A of the sliotar paper at its middle speed.
inline Sphere core_a() {
  return {.mass = 0.0896, .diameter = 0.0662};
}

/// Parameters of each law, as on its card, that bounce core A at 15 m/s with e
/// between 0.4 and 0.8.
inline ParameterValues typical_parameters(const std::string& law) {
  ParameterValues values;
  for (const ParameterCard& card : find_law(law).parameters) values[card.name] = card.typical;
  return values;
}

/// The parameter that makes a law lose energy; at zero the law is elastic.
inline std::string loss_parameter(const std::string& law) {
  return find_law(law).loss_parameter;
}

inline LumpedProblem typical_problem(const std::string& law) {
  return {.sphere = core_a(),
          .impact = {.speed = 15.0, .separation = SeparationRule::zero_force},
          .model = {.law = law, .parameters = typical_parameters(law)},
          .controls = {}};
}

}  // namespace rebound::test
