#include "comparisons/models/effects/effect.hpp"
#include "comparisons/models/effects/inertial/standard_gravity.hpp"

namespace rebound {

Effect gravity_effect() {
  return {
      .card = {.name = "gravity",
               .kind = EffectKind::inertial,
               .family = EffectFamily::dynamics,
               .sentence = "The weight of the ball acts during contact.",
               .equation = "m x'' = m g - F, g = 9.80665 m/s^2",
               .size_dimension = dimension::none,
               .range = from_to(0.0, 1.0),
               .prior_scale = 1.0,
               .is_switch = true,
               .signature = "Slow impacts alone: peak force and contact time a little larger; 13 % "
                            "of the peak force at 0.1 m/s, 0.1 % at 5 m/s.",
               .experiment = "A drop from a few millimetres, or the same impact on a vertical "
                             "plate.",
               .source = "m g over peak force of a Hertz impact; standard gravity",
               .moves = ImpactChange{}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.gravity = choice.size * standard_gravity;
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.gravity = choice.size * standard_gravity; },
  };
}

}  // namespace rebound
