#include "comparisons/models/effects/free_form/curve_points.hpp"

namespace rebound {
namespace {

constexpr double usual_pull = 0.1;  // over F_r, that surprises nobody

EffectParameterCard pull_point(const std::string& name, const std::string& sentence) {
  return {.name = name,
          .sentence = sentence,
          .dimension = dimension::none,
          .range = from_to(0.0, 1.0),
          .default_value = 0.0,
          .fitted = true,
          .kind = ParameterKind::linear,
          .scale = 0.2 * usual_pull,
          .prior_deviation = usual_pull};
}

/// What is left of the pull at the plate at points √(gap/G) = 1/5 … 1; by itself it falls off as
/// (1 − gap/G)².
EffectParameterCard beyond_point(int k) {
  const double gap = 0.04 * k * k;
  return {.name = "beyond_" + std::to_string(k),
          .sentence = "Share of the pull at the plate that is left at point " + std::to_string(k) +
                      " of the gap.",
          .dimension = dimension::none,
          .range = from_to(0.0, 2.0),
          .default_value = (1.0 - gap) * (1.0 - gap),
          .fitted = true,
          .kind = ParameterKind::linear,
          .scale = 0.3,
          .prior_deviation = 0.3};
}

PullCurves pull_curves(const EffectChoice& choice) {
  const auto number = [&](const std::string& name) { return choice.parameters.at(name); };
  PullCurves pull{.contact = {.end = 1.0},
                  .unloading = {.end = 1.0},
                  .beyond = {.end = 1.0},
                  .deflection_reach = number("reach"),
                  .gap_reach = number("reach") * number("gap_over_reach")};
  // The parabola through the pulls at touch, a sixth of the reach and all of it.
  const double at_touch = number("way_in_0"), at_sixth = number("way_in_2"),
               at_reach = number("way_in_5");
  for (std::size_t k = 0; k < FactorCurve::points; ++k) {
    const double w = 0.2 * static_cast<double>(k);
    pull.contact.value[k] = at_touch * (w - 0.4) * (w - 1.0) / 0.4 +
                            at_sixth * w * (w - 1.0) / -0.24 + at_reach * w * (w - 0.4) / 0.6;
  }
  pull.unloading.value[0] = choice.size - at_touch;
  for (std::size_t k = 1; k + 1 < FactorCurve::points; ++k)
    pull.unloading.value[k] = number("way_back_" + std::to_string(k));
  for (std::size_t k = 1; k < FactorCurve::points; ++k)
    pull.beyond.value[k] = number("beyond_" + std::to_string(k)) - 1.0;
  return pull;
}

std::vector<CurveCard> curves() {
  constexpr auto pull = "pull_over_reference_force";
  CurveCard back{.of = "share_of_largest_deflection_on_the_way_back", .quantity = pull};
  CurveCard beyond{.of = "gap_over_its_reach", .quantity = "share_of_pull_at_the_plate"};
  for (int k = 1; k < 5; ++k)
    back.points.push_back({"way_back_" + std::to_string(k), 0.04 * k * k});
  for (int k = 1; k < 6; ++k)
    beyond.points.push_back({"beyond_" + std::to_string(k), 0.04 * k * k});
  return {{.of = "deflection_over_radius_on_the_way_in",
           .reach = "reach",
           .quantity = pull,
           .points = {{"way_in_0", 0.0}, {"way_in_2", 0.16}, {"way_in_5", 1.0}}},
          std::move(back),
          std::move(beyond)};
}

}  // namespace

Effect pull_curves_effect() {
  EffectCard card{
      .name = "pull-curves",
      .kind = EffectKind::boundary,
      .family = EffectFamily::surface,
      .sentence =
          "Ball and plate pull at each other along curves: the surface family without a "
          "formula.",
      .equation =
          "- F_r [l(x) + u(x/x_max) on the way back], beyond the plate - F_r s b(gap/G), "
          "F_r = F_e at the reach; the size s is the pull that is left at x = 0",
      .size_dimension = dimension::none,
      .range = from_to(0.0, 1.0),
      .prior_scale = 0.2 * usual_pull,
      .parameters = {pull_point("way_in_0", "Pull over F_r at touch."),
                     pull_point("way_in_2", "Pull over F_r at a sixth of the reach."),
                     pull_point("way_in_5", "Pull over F_r at the reach.")},
      .signature = "Force below zero when the ball has left; the same pull at every speed.",
      .experiment = "Slow impacts, where the pull is a larger share; a powdered or a wet plate.",
      .source =
          "curves as of Johnson, Kendall & Roberts 1971 and Maugis 1992, without their formula",
      .is_free_form = true,
      .free_form_of = "adhesion",
      .curves = curves()};
  for (int k = 1; k < 5; ++k)
    card.parameters.push_back(
        pull_point("way_back_" + std::to_string(k),
                   "Further pull over F_r on the way back at point " + std::to_string(k) + "."));
  for (int k = 1; k < 6; ++k) card.parameters.push_back(beyond_point(k));
  card.parameters.push_back({.name = "reach",
                             .sentence = "Deflection over radius that F_r belongs to.",
                             .dimension = dimension::none,
                             .range = from_to(0.005, 1.0),
                             .default_value = 0.3,
                             .kind = ParameterKind::largest_deflection});
  card.parameters.push_back({.name = "gap_over_reach",
                             .sentence = "Gap where the pull ends, over that deflection.",
                             .dimension = dimension::none,
                             .range = from_to(1e-3, 1.0),
                             .default_value = 0.1,
                             .fitted = true,
                             .tried = {0.005, 0.05, 0.3}});
  return {.card = std::move(card),
          .to_lumped = [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.pull = pull_curves(choice);
          }};
}

}  // namespace rebound
