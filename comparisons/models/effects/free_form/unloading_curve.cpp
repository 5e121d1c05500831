#include "comparisons/models/effects/free_form/unloading_numbers.hpp"

namespace rebound {

Effect unloading_curve_effect() {
  return {
      .card = {.name = "unloading-curve",
               .kind = EffectKind::dissipative,
               .family = EffectFamily::history,
               .sentence = "Elastic force below the largest deflection times a curve: the "
                           "history family without a formula.",
               .equation = "F_e(eta) [1 + (x_max/x_r)^growth g(u)] while x < x_max, eta = (x - "
                           "set x_max)/(1 - set), u = 1 - sqrt(1 - eta/x_max), g smooth "
                           "through values at 0, 1/5 ... 4/5 and 0 at 1; the size is -g at 2/5",
               .size_dimension = dimension::none,
               .range = from_to(0.0, 0.95),
               .prior_scale = 0.3,
               .parameters = unloading_numbers(),
               .signature = "Loading unchanged; unloading lower, whatever the rate; by the same "
                            "share at every speed where growth is zero.",
               .experiment = "A slow cycle: what is left of the loop at no rate is history.",
               .source = "piecewise cubic factor; Walton & Braun 1986 for the kind",
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
            std::array<double, UnloadingCurve::points>& value =
                problem.material.strain.unloading.value;
            for (const std::size_t k : {0, 1, 3, 4})
              value[k] += choice.parameters.at("at_" + std::to_string(k));
            value[2] -= choice.size;
          }};
}

}  // namespace rebound
