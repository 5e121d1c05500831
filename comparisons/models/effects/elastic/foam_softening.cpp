#include "comparisons/models/effects/elastic/elastic_numbers.hpp"

namespace rebound {

Effect foam_softening_effect() {
  return {
      .card = {.name = "foam-softening",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "Cell walls buckle: the stiffness falls toward a plateau after the "
                           "first few per cent.",
               .equation = "F_e [1 - s (1 - exp(-x/(d R)))], d depth; F_d follows by damping_share",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::softening>.range,
               .prior_scale = 0.2,
               .parameters = {damping_share_number(),
                              shape_number("depth_over_radius",
                                           "Deflection over which the stiffness falls, over R.",
                                           limit_of<&ElasticFactors::softening_depth>.range, 0.05,
                                           {0.02, 0.15})},
               .signature = "Local slope of ln F over ln x below the law from small deflection on; "
                            "flatter top of the pulse, contact time nearly flat in speed.",
               .experiment = "Slow compression to the same depth: the plateau is there too; repeat "
                             "after a rest to tell it from damage.",
               .source = "Gibson & Ashby, cellular solids; plateau of closed-cell foams and cork "
                         "at 5 to 60 % strain",
               .moves = ImpactChange{.peak_force = -1, .contact_time = 1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            set_factor(choice, &ElasticFactors::softening, problem);
            set_shape(choice.parameters.at("depth_over_radius"), &ElasticFactors::softening_depth,
                      problem);
          },
      .to_fem = [](const EffectChoice& choice,
                   FemProblem& problem) { problem.material.strain.softening += choice.size; },
  };
}

}  // namespace rebound
