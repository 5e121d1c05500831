#include "comparisons/models/effects/effect.hpp"

namespace rebound {

Effect adhesion_effect() {
  return {
      .card = {.name = "adhesion",
               .kind = EffectKind::boundary,
               .family = EffectFamily::surface,
               .sentence =
                   "Ball and plate stick: a constant pull while in contact, to pull-off, and a "
                   "neck that tears.",
               .equation =
                   "- 2 pi R s from first touch to pull-off, then - 2 pi R s (1 - gap/G)^2, "
                   "G = range_over_radius R",
               .size_dimension = dimension::energy_per_area,
               .range = limit_of<&Mechanisms::adhesion>.range,
               .prior_scale = 20.0,
               .parameters = {{.name = "range_over_radius",
                               .sentence =
                                   "Gap beyond which there is no pull; 0: no neck after contact,"
                                   " in FE chosen so that the pull is Derjaguin's.",
                               .dimension = dimension::none,
                               .range = from_to(0.0, 0.25),
                               .default_value = 0.0,
                               .fitted = true,
                               .is_left_open = true,
                               .tried = {0.05, 0.01},
                               .most_fitted = 0.1}},
               .jumps_at_touch = true,
               .signature = "A dip where the force begins and one where it ends; restitution that "
                            "rises with speed, where a neck takes energy.",
               .experiment = "Sign of the slope of e at low speed; the same shots on a powdered or "
                             "a wet plate.",
               .source = "Derjaguin, Muller & Toporov 1975; wet impacts: Gorin et al.",
               .moves = ImpactChange{.contact_time = 1, .restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.adhesion = choice.size;
            problem.model.mechanisms.adhesion_reach = choice.parameters.at("range_over_radius");
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            problem.adhesion = {
                .work = choice.size,
                .range = choice.parameters.at("range_over_radius") * problem.sphere.radius()};
          },
  };
}

}  // namespace rebound
