#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "lumped/problem/lumped_problem.hpp"

namespace rebound::test {

/// Core A of the sliotar paper at its middle speed.
inline Sphere core_a() { return {.mass = 0.0896, .diameter = 0.0662}; }

/// Parameters of each law that bounce core A at 15 m/s with e between 0.4 and
/// 0.8. A new law needs a line here, or the battery fails.
inline ParameterValues typical_parameters(const std::string& law) {
  static const std::map<std::string, ParameterValues> table = {
      {"linear-kelvin-voigt", {{"stiffness", 2.5e5}, {"damping", 60.0}}},
      {"equivalent-kelvin-voigt",
       {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 17.63e4},
        {"representative_deflection", 3.97e-3}}},
      {"hunt-crossley", {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 17.63e4}}},
      {"hertz-damped", {{"stiffness", 3.5e6}, {"damping", 700.0}}},
      {"power-law",
       {{"damping_exponent", 0.25}, {"stiffness_exponent", 0.25}, {"stiffness", 8e5},
        {"damping", 200.0}}},
      {"kuwabara-kono", {{"stiffness", 3.5e6}, {"dissipation_time", 1.3e-4}}},
      {"tsuji", {{"stiffness", 3.5e6}, {"damping", 200.0}}},
      {"finite-sphere-hertz",
       {{"stiffness", 3.5e6}, {"dissipation_time", 1.0e-4}, {"poisson_ratio", 0.4},
        {"radius", 0.0331}}},
      {"standard-linear-solid",
       {{"stiffness", 2.9e6}, {"ratio", 1.0}, {"relaxation_time", 1e-3}}},
  };
  const auto found = table.find(law);
  if (found == table.end()) throw std::logic_error("no typical parameters for law " + law);
  return found->second;
}

/// The parameter that makes a law lose energy; at zero the law is elastic.
inline std::string loss_parameter(const std::string& law) {
  for (const char* name : {"damping", "dissipation_time"})
    if (typical_parameters(law).contains(name)) return name;
  return "ratio";
}

inline LumpedProblem typical_problem(const std::string& law) {
  return {.sphere = core_a(),
          .impact = {.speed = 15.0, .separation = SeparationRule::zero_force},
          .model = {.law = law, .parameters = typical_parameters(law)},
          .controls = {}};
}

}  // namespace rebound::test
