#include "comparisons/models/effects/free_form/curve_points.hpp"

namespace rebound {

Effect elastic_curve_effect() {
  EffectCard card{
      .name = "elastic-curve",
      .kind = EffectKind::elastic,
      .family = EffectFamily::elastic,
      .sentence =
          "Elastic force times a curve over the deflection: the elastic family without a "
          "formula.",
      .equation =
          "F_e [1 + g(x/R)], F_d [1 + c g(x/R)], g smooth through its values at 0, 1/5 ... 1 of "
          "the reach; the size is the last one, c the share in which damping follows",
      .size_dimension = dimension::none,
      .range = curve_range(),
      .prior_scale = 0.1,
      .parameters = curve_points("at", 5),
      .signature = "Loading and unloading alike, at every speed the same at the same deflection.",
      .experiment = "A slow compression shows the curve itself.",
      .source =
          "piecewise cubic factor; discrepancy as a function of the state, Kennedy & O'Hagan "
          "2001",
      .is_free_form = true,
      .curves = {curve_card("deflection_over_radius", "reach", "at", FactorCurve::points - 1)},
      .moves = ImpactChange{.peak_force = 1, .contact_time = -1}};
  card.parameters.push_back({.name = "reach",
                             .sentence = "Deflection over radius at the last point.",
                             .dimension = dimension::none,
                             .range = from_to(0.005, 1.0),
                             .default_value = 0.3,
                             .kind = ParameterKind::largest_deflection});
  // Laws differ in it: Hunt and Crossley's damping grows with the elastic force, Tsuji's does not.
  card.parameters.push_back({.name = "damping_share",
                             .sentence = "Share in which the damping force follows the curve.",
                             .dimension = dimension::none,
                             .range = from_to(0.0, 1.0),
                             .default_value = 0.5,
                             .fitted = true,
                             .in_fem = false,  // branches follow all of the elastic stress there
                             .kind = ParameterKind::linear,
                             .scale = 0.3});
  return {.card = std::move(card),
          .to_lumped =
              [](const EffectChoice& choice, LumpedProblem& problem) {
                FactorCurve curve = curve_of(choice, "at", 5, choice.parameters.at("reach"));
                curve.value.back() = choice.size;
                add_curve(curve, problem.model.mechanisms.elastic.curve);
                for (double& value : curve.value) value *= choice.parameters.at("damping_share");
                problem.model.mechanisms.damping.elastic.curve = curve;
              },
          // The effective strain takes the place of x/R.
          .to_fem =
              [](const EffectChoice& choice, FemProblem& problem) {
                const FactorCurve curve = curve_of(choice, "at", 5, choice.parameters.at("reach"));
                StrainCurve& strain = problem.material.strain.curve;
                strain.value = curve.value;
                strain.value.back() = choice.size;
                strain.reach = curve.end;
              }};
}

}  // namespace rebound
