#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect hysteresis_effect() {
  return {
      .card = {.name = "hysteresis",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::history,
               .sentence = "Loss that does not depend on rate: unloading runs below loading.",
               .equation = "unloading: F_e [1 - s (1 - x/x_max)]",
               .size_dimension = dimension::none,
               .range = limit_of<&UnloadingMemory::hysteresis>.range,
               .prior_scale = 0.2,
               .signature = "Restitution the same at all speeds; loop of F over x of one shape, "
                            "closed at x = 0.",
               .experiment = "A slow loading and unloading loop: the loss is still there, which no "
                             "viscous loss can do.",
               .source = "Structural damping; Mullins-type softening of filled rubbers",
               .moves = ImpactChange{.restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.memory.hysteresis = choice.size;
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.strain.mullins += choice.size; },
  };
}

}  // namespace rebound
