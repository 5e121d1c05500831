#include "lumped/laws/tsuji.hpp"

#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

LawCard Tsuji::card() {
  return {
      .name = "tsuji",
      .equation = "F = stiffness x^1.5 + damping x^0.25 x'",
      .source = "Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011",
      .parameters = {stiffness_card("Hertz stiffness, (4/3) E* sqrt(R) on a rigid plate.", 3.5e6,
                                    [](const ParameterValues& values) {
                                      return stiffness_dimension(values, "", 1.5);
                                    }),
                     damping_card("Damping force per x^0.25 x'; alpha sqrt(m stiffness) for the "
                                  "damping number alpha.",
                                  200.0,
                                  [](const ParameterValues& values) {
                                    return damping_dimension(values, "", 0.25);
                                  })},
      .damping_parameter = "damping",
      .loss_parameter = "damping"};
}

Tsuji Tsuji::from(const ParameterValues& values) {
  return {.stiffness = values.at("stiffness"), .damping = values.at("damping")};
}

double Tsuji::damping_for(const DampingRequest& request) {
  // λ = α √(m κ) with α = √5 ζ, and linear_damping is 2 ζ √(κ m).
  return 0.5 * std::sqrt(5.0) * linear_damping(request, request.parameters.at("stiffness"));
}

}  // namespace rebound
