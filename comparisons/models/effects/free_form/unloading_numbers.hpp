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
           .kind = ParameterKind::linear,
           .scale = 0.1,
           .prior_deviation = 0.2},
          {.name = "growth",
           .sentence = "Power of the largest deflection with which the curve grows.",
           .dimension = dimension::none,
           .range = limit_of<&UnloadingMemory::curve_growth>.range,
           .default_value = 0.0,
           .fitted = true,
           .kind = ParameterKind::linear,
           .scale = 0.5,
           .prior_deviation = 1.0},
          {.name = "deflection_reach",
           .sentence = "Largest deflection over radius at which the curve is as given.",
           .dimension = dimension::none,
           .range = from_to(0.005, 1.0),
           .default_value = 0.3,
           .kind = ParameterKind::largest_deflection}};
}

/// Writes them beside what the memory has already.
inline void set_unloading(const EffectChoice& choice, double radius, UnloadingMemory& memory) {
  memory.permanent_set += choice.parameters.at("set");
  memory.curve = {.end = 1.0};
  memory.curve_growth = choice.parameters.at("growth");
  memory.growth_deflection = choice.parameters.at("deflection_reach") * radius;
  for (const std::size_t k : {0, 1, 3, 4})
    memory.curve.value[k] = choice.parameters.at("at_" + std::to_string(k));
  memory.curve.value[2] = -choice.size;
}

}  // namespace rebound
