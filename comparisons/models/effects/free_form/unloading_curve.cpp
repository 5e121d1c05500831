#include "comparisons/models/effects/free_form/unloading_numbers.hpp"

namespace rebound {

Effect unloading_curve_effect() {
  return {
      .card = {.name = "unloading-curve",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::history,
               .sentence = "A force below the largest deflection that is a curve over the share "
                           "of it: the history family without a formula.",
               .equation = "F_e(x) + F_e(x_max) (x_max/x_r)^growth g(u) while x < x_max, u = 1 - "
                           "sqrt(1 - x/x_max), g smooth through values at 0, 1/5 ... 4/5 and 0 "
                           "at 1; the size is -g at 2/5",
               .size_dimension = dimension::none,
               .range = range_of_unloading(),
               .prior_scale = usual_unloading,
               .parameters = unloading_numbers(),
               .signature = "Loading unchanged; unloading lower, whatever the rate; by the same "
                            "share at every speed where growth is zero.",
               .experiment = "A slow cycle: what is left of the loop at no rate is history.",
               .source = "piecewise cubic curve; Walton & Braun 1986 for the kind",
               .is_free_form = true,
               .curves = {unloading_card()},
               .moves = ImpactChange{.restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            add_unloading(choice, problem.sphere.radius(), problem.model.mechanisms.memory);
          },
      // Every point against the largest strain it has seen itself.
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            add_unloading(choice, problem.material.strain.unloading);
          }};
}

}  // namespace rebound
