#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect adhesion_effect() {
  return {
      .card = {.name = "adhesion",
               .kind = EffectKind::boundary,
               .family = EffectFamily::surface,
               .sentence = "Ball and plate stick: a constant pull while in contact, to pull-off.",
               .equation = "- 2 pi R s, from first touch to pull-off",
               .size_dimension = dimension::energy_per_area,
               .range = limit_of<&Mechanisms::adhesion>.range,
               .prior_scale = 20.0,
               .parameters = {{.name = "range_over_radius",
                               .sentence =
                                   "Gap within which the surface is pulled, in FE; 0: chosen"
                                   " so that the pull is Derjaguin's.",
                               .dimension = dimension::none,
                               .range = from_to(0.0, 0.25),
                               .default_value = 0.0,
                               .fitted = true,
                               .in_lumped = false,
                               .is_left_open = true,
                               .tried = {0.05}}},
               .jumps_at_touch = true,
               .signature = "A dip where the force begins and one where it ends; restitution that "
                            "rises with speed, where a neck takes energy.",
               .experiment = "Sign of the slope of e at low speed; the same shots on a powdered or "
                             "a wet plate.",
               .source = "Derjaguin, Muller & Toporov 1975; wet impacts: Gorin et al.",
               .moves = ImpactChange{.contact_time = 1, .restitution = -1}},
      .to_lumped = [](const EffectChoice& choice,
                      LumpedProblem& problem) { problem.model.mechanisms.adhesion = choice.size; },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            problem.adhesion = {
                .work = choice.size,
                .range = choice.parameters.at("range_over_radius") * problem.sphere.radius()};
          },
  };
}

}  // namespace rebound
