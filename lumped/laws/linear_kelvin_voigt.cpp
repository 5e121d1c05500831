#include "lumped/laws/linear_kelvin_voigt.hpp"

#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard LinearKelvinVoigt::card() {
  return {.name = "linear-kelvin-voigt",
          .equation = "F = stiffness x + damping x'",
          .source = "Hanley et al., sliotar core impact, Eqs (4), (11)-(13)",
          .parameters = {stiffness_card("Spring constant.", 2.5e5,
                                        [](const ParameterValues&) {
                                          return dimension::force / dimension::length;
                                        }),
                         damping_card("Dashpot constant.", 60.0,
                                      [](const ParameterValues&) {
                                        return dimension::force / dimension::speed;
                                      })},
          .damping_parameter = "damping",
          .loss_parameter = "damping"};
}

LinearKelvinVoigt LinearKelvinVoigt::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"), .damping = values.at("damping")};
}

double LinearKelvinVoigt::damping_for(const DampingRequest& request) {
  return linear_damping(request, request.parameters.at("stiffness"));
}

}  // namespace rebound
