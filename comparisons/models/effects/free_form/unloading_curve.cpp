#include "comparisons/models/effects/free_form/curve_points.hpp"

#include "lumped/mechanisms/unloading_memory.hpp"

namespace rebound {
namespace {

/// Over x/x_max; the last point, where unloading begins, is held at one.
CurveCard unloading_card() {
  CurveCard card = curve_card("share_of_largest_deflection", "", "at", 2);
  card.level_is_the_laws = false;
  card.points.pop_back();
  card.points[2].sign = -1.0;
  for (CurveCard::Point& point : card.points) point.place = unloading_share(point.place);
  return card;
}

}  // namespace

Effect unloading_curve_effect() {
  return {.card = {.name = "unloading-curve",
                   .kind = EffectKind::dissipative,
                   .family = EffectFamily::history,
                   .sentence = "Elastic force below the largest deflection times a curve: the "
                               "history family without a formula.",
                   .equation = "F_e(x) [1 + g(u)] while x < x_max, u = 1 - sqrt(1 - x/x_max), g "
                               "smooth through values at 0, 1/5 ... 4/5 and 0 at 1; the size is -g "
                               "at 2/5",
                   .size_dimension = dimension::none,
                   .range = from_to(0.0, 0.95),
                   .prior_scale = 0.3,
                   .parameters = {curve_points("at", 5)[0], curve_points("at", 5)[1],
                                  curve_points("at", 5)[3], curve_points("at", 5)[4]},
                   .signature = "Loading unchanged; unloading lower, by the same share at every "
                                "speed and rate.",
                   .experiment = "A slow cycle: what is left of the loop at no rate is history.",
                   .source = "piecewise cubic factor; Walton & Braun 1986 for the kind",
                   .is_free_form = true,
                   .curves = {unloading_card()}},
          .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
            FactorCurve curve{.end = 1.0};
            for (const std::size_t k : {0, 1, 3, 4})
              curve.value[k] = choice.parameters.at("at_" + std::to_string(k));
            curve.value[2] = -choice.size;
            problem.model.mechanisms.memory.curve = curve;
          }};
}

}  // namespace rebound
