#include "lumped/laws/kuwabara_kono.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard KuwabaraKono::card() {
  return {
      .name = "kuwabara-kono",
      .equation = "F = stiffness (x^1.5 + 1.5 dissipation_time x^0.5 x')",
      .source = "Kuwabara & Kono 1987; Brilliantov et al. 1996",
      .parameters = {stiffness_card("Hertz stiffness, (4/3) E* sqrt(R) on a rigid plate.", 3.5e6,
                                    [](const ParameterValues& values) {
                                      return stiffness_dimension(values, "", 1.5);
                                    }),
                     dissipation_time_card(1.3e-4)},
      .damping_parameter = "",
      .loss_parameter = "dissipation_time"};
}

KuwabaraKono KuwabaraKono::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"), .dissipation_time = values.at("dissipation_time")};
}

}  // namespace rebound
