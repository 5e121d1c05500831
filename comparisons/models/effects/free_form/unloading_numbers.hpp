#pragma once

#include <cmath>
#include <vector>

#include "comparisons/models/effects/free_form/curve_points.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"

/// What the free forms of the history family share: a curve on the way back, and how it grows with
/// the largest deflection.
namespace rebound {

/// Over x/x_max; the last point, where unloading begins, is held at zero. The size is −g at 2/5.
inline CurveCard unloading_card() {
  CurveCard card = curve_card("share_of_largest_deflection", "", "at", 2);
  card.quantity = "share_of_largest_force";
  card.level_is_the_laws = false;
  card.points.pop_back();
  card.ends_at_nothing = true;
  card.points[2].sign = -1.0;
  for (CurveCard::Point& point : card.points) point.place = unloading_share(point.place);
  return card;
}

/// Least −g that is looked for: unloading above loading, by half of the largest force.
inline Range range_of_unloading() {
  return from_to(-0.5, 0.95);
}

/// Force lost at the middle of the way back, over the largest, that surprises nobody.
inline constexpr double usual_unloading = 0.1;

/// Points of the curve beside the size, the growth and the reach it is counted from.
inline std::vector<EffectParameterCard> unloading_numbers() {
  std::vector<EffectParameterCard> at = curve_points("at", 5);
  for (EffectParameterCard& value : at) value.range = from_to(-0.95, 0.5);
  return {at[0],
          at[1],
          at[3],
          at[4],
          {.name = "growth",
           .sentence = "Power of the largest deflection with which the curve grows.",
           .dimension = dimension::none,
           .range = limit_of<&UnloadingMemory::curve_growth>.range,
           .default_value = 0.0,
           .fitted = true,
           .in_fem = false,  // every point has a largest strain of its own
           .kind = ParameterKind::linear,
           .scale = 0.5,
           .prior_deviation = 1.0},
          {.name = "deflection_reach",
           .sentence = "Largest deflection over radius at which the curve is as given.",
           .dimension = dimension::none,
           .range = from_to(0.005, 1.0),
           .default_value = 0.3,
           .in_fem = false,
           .kind = ParameterKind::largest_deflection}};
}

/// Adds them to what the memory has already, whatever the order.
/// Errors: Error(bad_input) where a curve that is counted from another reach is there.
inline void add_unloading(const EffectChoice& choice, double radius, UnloadingMemory& memory) {
  const double reach = choice.parameters.at("deflection_reach") * radius;
  if (memory.curve.end != 0.0 && memory.growth_deflection != reach)
    throw Error(
        ExitCode::bad_input, "two curves of unloading must be counted from one reach",
        {.key = {}, .value = number_text(reach), .allowed = number_text(memory.growth_deflection)});
  FactorCurve curve{.end = 1.0};
  for (const std::size_t k : {0, 1, 3, 4})
    curve.value[k] = choice.parameters.at("at_" + std::to_string(k));
  curve.value[2] = -choice.size;
  add_curve(curve, memory.curve);
  memory.curve_growth += choice.parameters.at("growth");
  memory.growth_deflection = reach;
}

/// The same curve as a factor 1 + m on the elastic stress of every point in FE, at its own points:
/// m = g/(ε/ε_max)^1.5, at the first one that of half the way to the second. Unloading does not
/// turn the stress around: m ≥ −1.
inline void add_unloading(const EffectChoice& choice, UnloadingCurve& unloading) {
  for (std::size_t k = 0; k < UnloadingCurve::points; ++k) {
    const double g = k == 2 ? -choice.size : choice.parameters.at("at_" + std::to_string(k));
    const double place = std::max(0.5, static_cast<double>(k)) / UnloadingCurve::points;
    unloading.value[k] =
        std::max(-1.0, unloading.value[k] + g / std::pow(unloading_share(place), 1.5));
  }
}

}  // namespace rebound
