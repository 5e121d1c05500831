#include "comparisons/models/effects/elastic/elastic_numbers.hpp"

namespace rebound {

Effect densification_effect() {
  return {
      .card = {.name = "densification",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence =
                   "Cells close up: the force shoots up past a certain deflection, a quarter "
                   "radius where nothing else is said.",
               .equation = "F_e (1 + s <x/R - o>^2), o onset; F_d follows by damping_share",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::densification>.range,
               .prior_scale = 5.0,
               .parameters = {damping_share_number(),
                              shape_number("onset_over_radius",
                                           "Deflection over R from which cells close up.",
                                           limit_of<&ElasticFactors::densification_onset>.range,
                                           0.25, {0.05, 0.1, 0.15})},
               .signature = "Force history of the fastest shots alone: narrow extra peak at the "
                            "top; nothing below the onset.",
               .experiment = "One shot well above and one below the onset, or a slow compression "
                             "past it.",
               .source = "Gibson & Ashby, cellular solids (densification strain)",
               .moves = ImpactChange{.peak_force = 1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            set_factor(choice, &ElasticFactors::densification, problem);
            set_shape(choice.parameters.at("onset_over_radius"),
                      &ElasticFactors::densification_onset, problem);
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.strain.densification += choice.size; },
  };
}

}  // namespace rebound
