#include "lumped/laws/hertz_damped.hpp"

#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard HertzDamped::card() {
  return {
      .name = "hertz-damped",
      .equation = "F = stiffness x^1.5 + damping x^0.5 x'",
      .source = "Kuwabara & Kono 1987; Hanley et al., sliotar core impact, Eq. (5)",
      .parameters = {stiffness_card("Hertz stiffness, (4/3) E* sqrt(R) on a rigid plate.", 3.5e6,
                                    [](const ParameterValues& values) {
                                      return stiffness_dimension(values, "", 1.5);
                                    }),
                     damping_card("Damping force per x^0.5 x'; (3/2) A stiffness for the "
                                  "dissipation time A.",
                                  700.0,
                                  [](const ParameterValues& values) {
                                    return damping_dimension(values, "", 0.5);
                                  })},
      .damping_parameter = "",
      .loss_parameter = "damping"};
}

HertzDamped HertzDamped::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"), .damping = values.at("damping")};
}

}  // namespace rebound
