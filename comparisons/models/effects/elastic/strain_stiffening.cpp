#include "comparisons/models/effects/elastic/elastic_numbers.hpp"

namespace rebound {

Effect strain_stiffening_effect() {
  return {
      .card = {.name = "strain-stiffening",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "The ball hardens with strain: finite deformation or a material that "
                           "locks gently.",
               .equation = "F_e [1 + s (x/R) (x/x_r)^(p - 1)], s >= 0, x_r = R/10, p power; F_d "
                           "follows by damping_share",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::stiffening>.range,
               .prior_scale = 1.0,
               .parameters = {damping_share_number(),
                              shape_number("power",
                                           "Power p with which the excess grows with deflection.",
                                           limit_of<&ElasticFactors::stiffening_power>.range, 1.0,
                                           {2.0, 4.0})},
               .signature = "Local slope of ln F over ln x grows above the law at large "
                            "deflection; pulse more peaked, contact time falls faster with speed.",
               .experiment = "A deeper slow compression of the same ball, or a higher speed: the "
                             "excess grows with x alone, whatever the rate.",
               .source = "Tanaka et al. 2003 (impact of gel balls at large strain)",
               .moves = ImpactChange{.peak_force = 1, .contact_time = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            set_factor(choice, &ElasticFactors::stiffening, problem);
            set_shape(choice.parameters.at("power"), &ElasticFactors::stiffening_power, problem);
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.strain.stiffening += choice.size; },
  };
}

}  // namespace rebound
