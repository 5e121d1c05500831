#include "lumped/laws/power_law.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard PowerLaw::card() {
  const auto number = [](const ParameterValues&) { return dimension::none; };
  return {.name = "power-law",
          .equation = "F = stiffness x^n2 x + damping x^n1 x'",
          .source = "Hanley et al., sliotar core impact, Eq. (3)",
          .parameters =
              {{.name = "damping_exponent",
                .sentence = "Power n1 of the deflection in the damping force.",
                .dimension = number, .lowest = 0.0, .highest = 5.0, .lowest_allowed = true,
                .default_value = {}},
               {.name = "stiffness_exponent",
                .sentence = "Power n2 of the deflection in the stiffness; the elastic force "
                            "goes with n2 + 1.",
                .dimension = number, .lowest = -0.5, .highest = 4.0, .lowest_allowed = false,
                .default_value = {}},
               stiffness_card("Elastic force per x^(n2+1).",
                              [](const ParameterValues& values) {
                                return stiffness_dimension(values, "stiffness_exponent", 0.0, 1.0);
                              }),
               damping_card("Damping force per x^n1 x'.",
                            [](const ParameterValues& values) {
                              return damping_dimension(values, "damping_exponent", 0.0);
                            })},
          .damping_parameter = ""};
}

PowerLaw PowerLaw::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"),
          .damping = values.at("damping"),
          .elastic_power = Power(values.at("stiffness_exponent") + 1.0),
          .damping_power = Power(values.at("damping_exponent"))};
}

}  // namespace rebound
