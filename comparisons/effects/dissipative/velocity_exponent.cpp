#include "comparisons/effects/declarations.hpp"

namespace rebound {

Effect velocity_exponent_effect() {
  return {
      .card = {
          .name = "velocity-exponent",
          .kind = EffectKind::dissipative,
          .sentence = "Damping that is not in proportion to the rate.",
          .equation = "F_d |x'/v_r|^s, v_r = 10 m/s",
          .size_dimension = dimension::none,
          .lowest = -0.9,
          .highest = 3.0,
          .prior_scale = 0.2,
          .signature = "Slope of 1 - e over speed at fixed loop shape; towards s = -1 the "
                       "loss is of friction type and e constant.",
          .experiment = "Restitution at speeds a decade apart; the loop of a slow cyclic "
                        "compression.",
          .source = "Slopes of 1 - e over speed: 0 structural, 0.2 viscoelastic sphere, 1 "
                    "Hunt-Crossley with constant damping"
      },
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.damping.velocity_exponent = choice.size;
          },
  };
}

}  // namespace rebound
