#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect finite_sphere_effect() {
  return {
      .card = {.name = "finite-sphere",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "Centre-of-mass deflection is less than the approach of the contact, "
                           "since the ball is not a half-space.",
               .equation = "x = d - s C(nu) F_e/(E R), F_e at approach d, E from F_e at R/10 by "
                           "Hertz",
               .size_dimension = dimension::none,
               .range = limit_of<&FiniteSphere::share>.range,
               .prior_scale = 1.0,
               .is_switch = true,
               .parameters = {{.name = "poisson_ratio",
                               .sentence = "Poisson ratio of the ball.",
                               .dimension = dimension::none,
                               .range = limit_of<&FiniteSphere::poisson_ratio>.range,
                               .default_value = 0.4}},
               .signature = "Force above Hertz at the same centre-of-mass deflection: 20 % at a "
                            "contact radius of R/5, 46 % at 2R/5 for nu = 0.4; contact shorter.",
               .experiment = "Contact radius, or deflection of the pole, measured beside the "
                             "motion of the centre; both slow and fast tests show it.",
               .source = "Tatara 1991; linear-elastic finite-element solutions"},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.finite_sphere = {
                .share = choice.size, .poisson_ratio = choice.parameters.at("poisson_ratio")};
          },
  };
}

}  // namespace rebound
