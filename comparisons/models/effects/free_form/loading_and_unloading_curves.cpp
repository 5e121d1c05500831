#include "comparisons/models/effects/free_form/unloading_numbers.hpp"

namespace rebound {

Effect loading_and_unloading_curves_effect() {
  EffectCard card{
      .name = "loading-and-unloading-curves",
      .kind = EffectKind::dissipative,
      .family = EffectFamily::history,
      .sentence =
          "A body that yields: elastic force times a curve on the way in, and another "
          "on the way back: the history family where loading is not the law's.",
      .equation =
          "on the way in F_e [1 + l(x/R)], on the way back that of the deflection left "
          "times the curve of unloading-curve; the size is -g at 2/5",
      .size_dimension = dimension::none,
      .range = from_to(0.0, 0.95),
      .prior_scale = 0.3,
      .parameters = unloading_numbers(),
      .signature =
          "Loading bends where the body yields; unloading is steeper and ends early, more "
          "so at higher speeds.",
      .experiment = "A dent that stays; slow cycles to growing deflections.",
      .source = "piecewise cubic factors; Thornton 1997, Walton & Braun 1986 for the kind",
      .is_free_form = true,
      .after_single_effects = true,
      .curves = {curve_card("deflection_over_radius", "deflection_reach", "load"),
                 unloading_card()}};
  const std::vector<EffectParameterCard> load =
      curve_points("load", static_cast<int>(FactorCurve::points));
  card.parameters.insert(card.parameters.begin(), load.begin(), load.end());
  return {.card = std::move(card),
          .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.elastic.curve =
                curve_of(choice, "load", static_cast<int>(FactorCurve::points),
                         choice.parameters.at("deflection_reach"));
            set_unloading(choice, problem.sphere.radius(), problem.model.mechanisms.memory);
          }};
}

}  // namespace rebound
