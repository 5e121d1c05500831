#include "comparisons/models/effects/elastic/elastic_numbers.hpp"

namespace rebound {

Effect force_exponent_effect() {
  return {
      .card = {.name = "force-exponent",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "The force rises with another power of the deflection than the law "
                           "says.",
               .equation = "F_e (x/x_r)^s, x_r = R/10; F_d (x/x_r)^(c s), c damping_share",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::exponent>.range,
               .prior_scale = 0.1,
               .parameters = {damping_share_number()},
               .signature = "Slope of ln F over ln x on loading; contact time falls as "
                            "v^((1-n)/(1+n)) instead of v^-0.2, peak force rises as v^(2n/(n+1)).",
               .experiment = "Contact time over a wide range of speeds: it moves one way with "
                             "speed for any exponent, while a rate effect shifts its level; a slow "
                             "compression shows the same exponent.",
               .source = "Hertz 1882 generalised; log-log slopes of a power law"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            set_factor(choice, &ElasticFactors::exponent, problem);
          },
  };
}

}  // namespace rebound
