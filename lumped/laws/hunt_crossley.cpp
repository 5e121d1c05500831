#include "lumped/laws/hunt_crossley.hpp"

#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard HuntCrossley::card() {
  return {.name = "hunt-crossley",
          .equation = "F = x^n (stiffness + damping x')",
          .source = "Hunt & Crossley 1975; Hanley et al., sliotar core impact, Eqs (6)-(9)",
          .parameters = {hertz_exponent_card(),
                         stiffness_card("Elastic force per x^n.", 3.5e6,
                                        [](const ParameterValues& values) {
                                          return stiffness_dimension(values, "exponent", 1.5);
                                        }),
                         damping_card("Damping force per x^n x'.", 17.63e4,
                                      [](const ParameterValues& values) {
                                        return damping_dimension(values, "exponent", 1.5);
                                      })},
          .damping_parameter = "damping",
          .loss_parameter = "damping"};
}

HuntCrossley HuntCrossley::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"),
          .damping = values.at("damping"),
          .power = Power(values.at("exponent"))};
}

double HuntCrossley::damping_for(const DampingRequest& request) {
  return hunt_crossley_damping(request, request.parameters.at("stiffness"));
}

}  // namespace rebound
