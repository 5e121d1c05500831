#include "lumped/laws/standard_linear_solid.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard StandardLinearSolid::card() {
  return {.name = "standard-linear-solid",
          .equation = "F = stiffness x^1.5 + q,  q' = ratio stiffness (x^1.5)' - q/relaxation_time",
          .source = "Lee & Radok 1960; Ting 1966",
          .parameters =
              {stiffness_card("Long-term Hertz stiffness, (4/3) E* sqrt(R) on a rigid plate.",
                              [](const ParameterValues& values) {
                                return stiffness_dimension(values, "", 1.5);
                              }),
               {.name = "ratio",
                .sentence = "Branch over long-term stiffness; the instantaneous stiffness is "
                            "(1 + ratio) stiffness.",
                .dimension = [](const ParameterValues&) { return dimension::none; },
                .lowest = 0.0, .highest = 1000.0, .lowest_allowed = true, .default_value = {}},
               {.name = "relaxation_time",
                .sentence = "Time in which the branch lets go.",
                .dimension = [](const ParameterValues&) { return dimension::time; },
                .lowest = 0.0, .highest = 1e6, .lowest_allowed = false, .default_value = {}}},
          .damping_parameter = ""};
}

StandardLinearSolid StandardLinearSolid::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"),
          .ratio = values.at("ratio"),
          .relaxation_time = values.at("relaxation_time")};
}

}  // namespace rebound
