#include "comparisons/models/effects/free_form/unloading_numbers.hpp"

namespace rebound {
namespace {

constexpr const char* own_name = "loading-and-unloading-curves";

/// Loading of elastic-curve, or unloading of unloading-curve.
std::optional<EffectChoice> from_part_of(const EffectChoice& part) {
  EffectChoice whole{.name = own_name, .size = 0.0, .parameters = {}};
  if (part.name == "unloading-curve") {
    whole.size = part.size;
    whole.parameters = part.parameters;
    return whole;
  }
  if (part.name != "elastic-curve") return std::nullopt;
  constexpr std::size_t last = FactorCurve::points - 1;
  for (std::size_t k = 0; k < last; ++k)
    whole.parameters["load_" + std::to_string(k)] = part.parameters.at("at_" + std::to_string(k));
  whole.parameters["load_" + std::to_string(last)] = part.size;
  whole.parameters["deflection_reach"] = part.parameters.at("reach");
  return whole;
}

}  // namespace

Effect loading_and_unloading_curves_effect() {
  EffectCard card{
      .name = own_name,
      .kind = EffectKind::dissipative,
      .family = EffectFamily::history,
      .sentence =
          "A body that yields: elastic force times a curve on the way in, and a further curve "
          "on the way back: the history family where loading is not the law's.",
      .equation =
          "F_e [1 + l(x/R)], on the way back with the curve of unloading-curve beside it; the size "
          "is -g at 2/5",
      .size_dimension = dimension::none,
      .range = range_of_unloading(),
      .prior_scale = usual_unloading,
      .parameters = unloading_numbers(),
      .signature =
          "Loading bends where the body yields; unloading is steeper and ends early, more "
          "so at higher speeds.",
      .experiment = "A dent that stays; slow cycles to growing deflections.",
      .source = "piecewise cubic curves; Thornton 1997, Walton & Braun 1986 for the kind",
      .is_free_form = true,
      .after_single_effects = true,
      .curves = {curve_card("deflection_over_radius", "deflection_reach", "load"),
                 unloading_card()},
      .from_part = from_part_of};
  const std::vector<EffectParameterCard> load =
      curve_points("load", static_cast<int>(FactorCurve::points));
  card.parameters.insert(card.parameters.begin(), load.begin(), load.end());
  return {.card = std::move(card),
          .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
            add_curve(curve_of(choice, "load", static_cast<int>(FactorCurve::points),
                               choice.parameters.at("deflection_reach")),
                      problem.model.mechanisms.elastic.curve);
            add_unloading(choice, problem.sphere.radius(), problem.model.mechanisms.memory);
          }};
}

}  // namespace rebound
