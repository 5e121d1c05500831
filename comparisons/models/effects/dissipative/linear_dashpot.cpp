#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect linear_dashpot_effect() {
  return {
      .card = {.name = "linear-dashpot",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::rate,
               .sentence = "Damping that does not wait for a contact area: a force at the very "
                           "first touch.",
               .equation = "+ s x'",
               .size_dimension = dimension::force / dimension::speed,
               .range = limit_of<&DampingFactors::dashpot>.range,
               .prior_scale = 5.0,
               .jumps_at_touch = true,
               .signature = "F(0+) above zero and a pull before the end; restitution the same at "
                            "all speeds.",
               .experiment = "Sampling fast enough to see F in the first per cent of the contact: "
                             "a smooth ball starts at zero.",
               .source = "Kelvin-Voigt contact; Cross 1999 (measured force starts at zero)"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.damping.dashpot = choice.size;
          },
  };
}

}  // namespace rebound
