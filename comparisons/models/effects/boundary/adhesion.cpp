#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect adhesion_effect() {
  return {
      .card = {.name = "adhesion",
               .kind = EffectKind::boundary,
               .family = EffectFamily::surface,
               .sentence = "Ball and plate stick: a constant pull while in contact, to pull-off.",
               .equation = "- 2 pi R s, ramped in over the first 1 % of peak force",
               .size_dimension = dimension::energy_per_area,
               .range = limit_of<&Mechanisms::adhesion>.range,
               .prior_scale = 20.0,
               .signature = "A tensile tail at the end of the force; restitution that rises with "
                            "speed.",
               .experiment = "Sign of the slope of e at low speed; the same shots on a powdered or "
                             "a wet plate.",
               .source = "Derjaguin, Muller & Toporov 1975; wet impacts: Gorin et al.",
               .moves = ImpactChange{.contact_time = 1, .restitution = -1}},
      .to_lumped = [](const EffectChoice& choice,
                      LumpedProblem& problem) { problem.model.mechanisms.adhesion = choice.size; },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.adhesion.work = choice.size; },
  };
}

}  // namespace rebound
