#include "lumped/laws/equivalent_kelvin_voigt.hpp"

#include <cmath>

#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard EquivalentKelvinVoigt::card() {
  return {.name = "equivalent-kelvin-voigt",
          .equation = "F = stiffness xR^(n-1) x + damping xR^n x'",
          .source = "Hanley et al., sliotar core impact, Eqs (14)-(16)",
          .parameters = {hertz_exponent_card(),
                         stiffness_card("Hunt-Crossley stiffness that is linearised.", 3.5e6,
                                        [](const ParameterValues& values) {
                                          return stiffness_dimension(values, "exponent", 1.5);
                                        }),
                         damping_card("Hunt-Crossley damping that is linearised.", 17.63e4,
                                      [](const ParameterValues& values) {
                                        return damping_dimension(values, "exponent", 1.5);
                                      }),
                         {.name = "representative_deflection",
                          .sentence =
                              "Deflection xR the law is frozen at; the paper takes the mean over "
                              "the contact.",
                          .dimension = [](const ParameterValues&) { return dimension::length; },
                          .range = above_up_to(0.0, 10.0),
                          .default_value = {},
                          .typical = 3.97e-3}},
          .damping_parameter = "damping",
          .loss_parameter = "damping"};
}

EquivalentKelvinVoigt EquivalentKelvinVoigt::from(const ParameterValues& values) {
  const double n = values.at("exponent");
  const double deflection = values.at("representative_deflection");
  return {.linear_stiffness = values.at("stiffness") * std::pow(deflection, n - 1.0),
          .linear_damping = values.at("damping") * std::pow(deflection, n),
          .exponent = n,
          .representative_deflection = deflection};
}

double EquivalentKelvinVoigt::damping_for(const DampingRequest& request) {
  ParameterValues undamped = request.parameters;
  undamped["damping"] = 0.0;
  const double n = undamped.at("exponent");
  return rebound::linear_damping(request, from(undamped).linear_stiffness) /
         std::pow(undamped.at("representative_deflection"), n);
}

}  // namespace rebound
