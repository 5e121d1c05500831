#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect densification_effect() {
  return {
      .card = {.name = "densification",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "Cells close up: the force shoots up past a quarter radius of "
                           "deflection.",
               .equation = "F_e (1 + s <x/R - 1/4>^2)",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::densification>.range,
               .prior_scale = 5.0,
               .signature = "Force history of the fastest shots alone: narrow extra peak at the "
                            "top; nothing below x = R/4.",
               .experiment = "One shot well above and one below x = R/4, or a slow compression "
                             "past it.",
               .source = "Gibson & Ashby, cellular solids (densification strain)",
               .moves = ImpactChange{.peak_force = 1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.elastic.densification = choice.size;
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.strain.densification += choice.size; },
  };
}

}  // namespace rebound
