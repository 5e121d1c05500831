#include "lumped/laws/power_law.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard PowerLaw::card() {
  const auto number = [](const ParameterValues&) { return dimension::none; };
  return {
      .name = "power-law",
      .equation = "F = stiffness x^n2 x + damping x^n1 x'",
      .source = "Hanley et al., sliotar core impact, Eq. (3)",
      .parameters = {{.name = "damping_exponent",
                      .sentence = "Power n1 of the deflection in the damping force.",
                      .dimension = number,
                      .range = from_to(0.0, 5.0),
                      .default_value = {},
                      .typical = 0.25},
                     {.name = "stiffness_exponent",
                      .sentence = "Power n2 of the deflection in the stiffness; the elastic force "
                                  "goes with n2 + 1.",
                      .dimension = number,
                      .range = above_up_to(-0.5, 4.0),
                      .default_value = {},
                      .typical = 0.25},
                     stiffness_card("Elastic force per x^(n2+1).", 8e5,
                                    [](const ParameterValues& values) {
                                      return stiffness_dimension(values, "stiffness_exponent", 0.0,
                                                                 1.0);
                                    }),
                     damping_card("Damping force per x^n1 x'.", 200.0,
                                  [](const ParameterValues& values) {
                                    return damping_dimension(values, "damping_exponent", 0.0);
                                  })},
      .damping_parameter = "",
      .loss_parameter = "damping"};
}

PowerLaw PowerLaw::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"),
          .damping = values.at("damping"),
          .elastic_power = Power(values.at("stiffness_exponent") + 1.0),
          .damping_power = Power(values.at("damping_exponent"))};
}

}  // namespace rebound
