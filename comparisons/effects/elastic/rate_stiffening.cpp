#include "comparisons/effects/declarations.hpp"

namespace rebound {

Effect rate_stiffening_effect() {
  return {
      .card = {
          .name = "rate-stiffening",
          .kind = EffectKind::elastic,
          .sentence = "A flat spectrum of relaxation times: the ball is stiffer the faster it "
                      "is hit.",
          .equation = "stiffness times (v0/v_r)^s, v_r = 10 m/s",
          .size_dimension = dimension::none,
          .lowest = -1.0,
          .highest = 2.0,
          .prior_scale = 0.1,
          .signature = "Amplitude of force scales with speed beyond the law while the "
                       "exponent of F over x stays; slow stiffness far below the dynamic one.",
          .experiment = "Stiffness at three rates at least: slow, intermediate, impact. A "
                        "single speed cannot tell it from a stiffer ball.",
          .source = "Power-law branch of closed-cell foams; Bryson 2009; Lane 2018"
      },
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.elastic.rate_exponent = choice.size;
          },
  };
}

}  // namespace rebound
