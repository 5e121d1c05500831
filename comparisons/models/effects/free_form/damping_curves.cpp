#include <cmath>

#include "comparisons/models/effects/free_form/curve_points.hpp"

namespace rebound {

Effect damping_curves_effect() {
  EffectCard card{
      .name = "damping-curves",
      .kind = EffectKind::dissipative,
      .family = EffectFamily::rate,
      .sentence =
          "A damper whose coefficient is a curve over deflection, and a curve over the rate on all "
          "damping: the rate family without a formula.",
      .equation =
          "[F_d + (F_r/v_r) d((x/R)^(1/4)) v] [1 + h(|v|)], F_r = F_e at the reach, v_r = "
          "rate_reach, "
          "both curves smooth through values at 0, 1/5 ... 1 of their reach; the size is h at 2/5",
      .size_dimension = dimension::none,
      .range = curve_range(),
      .prior_scale = 0.3,
      .parameters = curve_points("deflection", 6),
      .signature =
          "Odd in the rate: the force differs between loading and unloading at the same "
          "deflection, and not where the ball turns.",
      .experiment = "Further speeds; the rate at a deflection is what changes.",
      .source = "piecewise cubic curves; restoring force surface, Masri & Caughey 1979",
      .is_free_form = true,
      .curves = {curve_card("deflection_over_radius", "deflection_reach", "deflection"),
                 curve_card("rate_m_s", "rate_reach", "rate", 2)}};
  CurveCard& damper = card.curves.front();
  damper.quantity = "added_damping_over_reference";
  damper.level_is_the_laws = false;
  for (CurveCard::Point& point : damper.points) point.place = std::pow(point.place, 4);
  for (EffectParameterCard& value : card.parameters) {
    value.range = from_to(-5.0, 5.0);
    card.begins_from[value.name] = 0.1;  // a dashpot
  }
  const std::vector<EffectParameterCard> rates = curve_points("rate", 6);
  for (const std::size_t k : {0, 1, 3, 4, 5}) card.parameters.push_back(rates[k]);
  card.parameters.push_back({.name = "deflection_reach",
                             .sentence = "Deflection over radius at the last point of d.",
                             .dimension = dimension::none,
                             .range = from_to(0.005, 1.0),
                             .default_value = 0.3,
                             .kind = ParameterKind::largest_deflection});
  card.parameters.push_back({.name = "rate_reach",
                             .sentence = "Rate at the last point of h.",
                             .dimension = dimension::speed,
                             .range = from_to(1e-3, 1e3),
                             .default_value = 30.0,
                             .kind = ParameterKind::largest_rate});
  return {.card = std::move(card),
          .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
            DampingFactors& damping = problem.model.mechanisms.damping;
            damping.added = curve_of(choice, "deflection", 6,
                                     std::pow(choice.parameters.at("deflection_reach"), 0.25));
            damping.rate_curve.end = choice.parameters.at("rate_reach");
            for (const std::size_t k : {0, 1, 3, 4, 5})
              damping.rate_curve.value[k] = choice.parameters.at("rate_" + std::to_string(k));
            damping.rate_curve.value[2] = choice.size;
          }};
}

}  // namespace rebound
