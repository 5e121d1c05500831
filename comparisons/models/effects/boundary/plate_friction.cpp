#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect plate_friction_effect() {
  return {
      .card = {.name = "plate-friction",
               .kind = EffectKind::boundary,
               .family = EffectFamily::surface,
               .sentence = "The plate rubs: it holds the contact from spreading.",
               .equation = "none: a law's stiffness absorbs it; FE: Coulomb friction",
               .size_dimension = dimension::none,
               .range = limit_of<&Plate::friction>.range,
               .prior_scale = 0.3,
               .signature = "Slightly stiffer contact, below 1 % at nu = 0.4, up to 10 % at nu = "
                            "0; a little loss by slip.",
               .experiment = "The same shots on a lubricated plate.",
               .source = "Spence 1968; stiffness ratio of a stuck flat punch (1 - nu) ln(3 - 4 "
                         "nu)/(1 - 2 nu)",
               .moves = ImpactChange{}},
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.plate.friction = choice.size; },
  };
}

}  // namespace rebound
