#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"

/// Further numbers of a free form: values g of a factor 1 + g at evenly spaced points.
namespace rebound {

/// Largest |g| that surprises nobody: the standard deviation of the prior that keeps a curve near
/// one where the data say nothing.
inline constexpr double usual_curve_value = 0.5;

/// Value g of a curve at a point, of any sign.
inline Range curve_range() {
  return from_to(-0.9, 20.0);
}

/// PREFIX_0 … PREFIX_(count − 1).
inline std::vector<EffectParameterCard> curve_points(const std::string& prefix, int count) {
  std::vector<EffectParameterCard> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    points.push_back({.name = prefix + "_" + std::to_string(k),
                      .sentence = "Value of g at point " + std::to_string(k) + ".",
                      .dimension = dimension::none,
                      .range = curve_range(),
                      .default_value = 0.0,
                      .fitted = true,
                      .kind = ParameterKind::linear,
                      .scale = usual_curve_value,
                      .prior_deviation = usual_curve_value});
  return points;
}

/// The curve of those numbers; further points stay as they are.
inline FactorCurve curve_of(const EffectChoice& choice, const std::string& prefix, int count,
                            double end) {
  FactorCurve curve{.end = end};
  for (int k = 0; k < count; ++k)
    curve.value[static_cast<std::size_t>(k)] =
        choice.parameters.at(prefix + "_" + std::to_string(k));
  return curve;
}

}  // namespace rebound
