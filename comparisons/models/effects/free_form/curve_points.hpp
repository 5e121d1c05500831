#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

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

/// What stands in a card of such a curve over `of`; the point `size_at` is the size of the effect.
inline CurveCard curve_card(const std::string& of, const std::string& reach,
                            const std::string& prefix, std::size_t size_at = FactorCurve::points) {
  CurveCard card{.of = of, .reach = reach, .level_is_the_laws = true, .is_even = true};
  for (std::size_t k = 0; k < FactorCurve::points; ++k)
    card.points.push_back({k == size_at ? "" : prefix + "_" + std::to_string(k),
                           static_cast<double>(k) / static_cast<double>(FactorCurve::points - 1)});
  return card;
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

/// Adds a curve to what is there, whatever the order.
/// Errors: Error(bad_input) where a curve of another reach is there.
inline void add_curve(const FactorCurve& curve, FactorCurve& to) {
  if (to.end != 0.0 && to.end != curve.end)
    throw Error(ExitCode::bad_input, "two curves over one quantity must have one reach",
                {.key = {}, .value = number_text(curve.end), .allowed = number_text(to.end)});
  to.end = curve.end;
  for (std::size_t k = 0; k < FactorCurve::points; ++k) to.value[k] += curve.value[k];
}

}  // namespace rebound
