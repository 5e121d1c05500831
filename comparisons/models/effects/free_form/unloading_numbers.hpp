#pragma once

#include <cmath>
#include <vector>

#include "comparisons/models/effects/free_form/curve_points.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"

/// What the free forms of the history family share: a curve on the way back, how it grows with the
/// largest deflection, and what is left of that.
namespace rebound {

/// Over x/x_max; the last point, where unloading begins, is held at one. The size is −g at 2/5.
inline CurveCard unloading_card() {
  CurveCard card = curve_card("share_of_largest_deflection", "", "at", 2);
  card.level_is_the_laws = false;
  card.points.pop_back();
  card.points[2].sign = -1.0;
  for (CurveCard::Point& point : card.points) point.place = unloading_share(point.place);
  return card;
}

/// Points of the curve beside the size, the set, the growth and the reach it is counted from.
inline std::vector<EffectParameterCard> unloading_numbers() {
  const std::vector<EffectParameterCard> at = curve_points("at", 5);
  return {at[0],
          at[1],
          at[3],
          at[4],
          {.name = "set",
           .sentence = "Deflection that is left over the largest, as of permanent-set.",
           .dimension = dimension::none,
           .range = limit_of<&UnloadingMemory::permanent_set>.range,
           .default_value = 0.0,
           .fitted = true,
           .in_fem = false,  // there it is a network that yields, an effect of its own
           .kind = ParameterKind::linear,
           .scale = 0.1,
           .prior_deviation = 0.2},
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
  memory.permanent_set += choice.parameters.at("set");
  memory.curve_growth += choice.parameters.at("growth");
  memory.growth_deflection = reach;
}

}  // namespace rebound
