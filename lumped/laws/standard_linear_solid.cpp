#include "lumped/laws/standard_linear_solid.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard StandardLinearSolid::card() {
  return {
      .name = "standard-linear-solid",
      .equation = "F = stiffness x^1.5 + q,  q' = ratio stiffness (x^1.5)' - q/relaxation_time",
      .source = "Lee & Radok 1960; Ting 1966",
      .parameters = {stiffness_card("Long-term Hertz stiffness, (4/3) E* sqrt(R) on a rigid plate.",
                                    2.9e6,
                                    [](const ParameterValues& values) {
                                      return stiffness_dimension(values, "", 1.5);
                                    }),
                     {.name = "ratio",
                      .sentence = "Branch over long-term stiffness; the instantaneous stiffness is "
                                  "(1 + ratio) stiffness.",
                      .dimension = [](const ParameterValues&) { return dimension::none; },
                      .range = from_to(0.0, 1000.0),
                      .default_value = {},
                      .typical = 1.0},
                     {.name = "relaxation_time",
                      .sentence = "Time in which the branch lets go.",
                      .dimension = [](const ParameterValues&) { return dimension::time; },
                      .range = above_up_to(0.0, 1e6),
                      .default_value = {},
                      .typical = 1e-3}},
      .damping_parameter = "",
      .loss_parameter = "ratio"};
}

StandardLinearSolid StandardLinearSolid::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"),
          .ratio = values.at("ratio"),
          .relaxation_time = values.at("relaxation_time")};
}

}  // namespace rebound
