#include "comparisons/discrepancy/diagnosis/effect_grid.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

constexpr double size_step = 0.05;             // of the prior scale
constexpr double smallest_tried = 1.0 / 64.0;  // of it: plates are stiff by orders of magnitude

/// The numbers of one parameter that are tried; empty: it stays as it is.
std::vector<double> tried_values(const EffectParameterCard& parameter, const Observations& seen) {
  std::vector<double> values;
  if (parameter.kind == ParameterKind::shot) {
    for (const MeasuredImpact& shot : seen.shots)
      if (shot.number > 0) values.push_back(shot.number);
    return values;
  }
  if (!parameter.fitted) return values;
  if (!parameter.tried.empty()) return parameter.tried;
  if (parameter.kind == ParameterKind::linear) return {parameter.default_value};
  for (const double factor : {0.1, 0.3, 1.0, 3.0, 10.0})
    values.push_back(std::clamp(factor * parameter.default_value, parameter.range.lowest,
                                parameter.range.highest));
  return values;
}

}  // namespace

std::vector<EffectChoice> over_parameters(const EffectCard& card, const EffectChoice& effect,
                                          const Observations& seen) {
  std::vector<EffectChoice> all{effect};
  for (const auto& parameter : card.parameters) {
    const std::vector<double> values = tried_values(parameter, seen);
    if (values.empty()) continue;
    std::vector<EffectChoice> next;
    for (const EffectChoice& one : all)
      for (const double value : values) {
        next.push_back(one);
        next.back().parameters[parameter.name] = value;
      }
    all = std::move(next);
  }
  return all;
}

std::vector<EffectChoice> small_effects(const EffectCard& card, const Observations& seen) {
  std::vector<double> sizes = card.tried;
  if (sizes.empty() && (card.is_switch || !std::isfinite(card.null))) {
    sizes = {card.is_switch ? 1.0 : card.prior_scale};
  } else if (sizes.empty()) {
    const double step = size_step * card.prior_scale;
    sizes = {card.null + step <= card.range.highest ? card.null + step : card.null - step};
  }
  std::vector<EffectChoice> all;
  for (const double size : sizes)
    for (auto& choice : over_parameters(card, {card.name, size, {}}, seen)) all.push_back(choice);
  return all;
}

std::vector<EffectChoice> finite_effects(const EffectCard& card, const Observations& seen) {
  std::vector<EffectChoice> all;
  const auto add = [&](double size) {
    if (size < card.range.lowest || size > card.range.highest) return;
    for (auto& choice : over_parameters(card, {card.name, size, {}}, seen)) all.push_back(choice);
  };
  if (card.is_switch) {
    add(1.0);
    return all;
  }
  for (const double size : card.tried) add(size);
  if (!card.tried.empty()) return all;
  const double null = std::isfinite(card.null) ? card.null : 0.0;
  // A fine grid of the parameters needs no fine one of the size beside it.
  const bool many = over_parameters(card, {card.name, card.prior_scale, {}}, seen).size() > 10;
  for (double factor = smallest_tried; factor < 8.0; factor *= many ? 4.0 : 2.0) {
    add(null + factor * card.prior_scale);
    add(null - factor * card.prior_scale);
  }
  return all;
}

}  // namespace rebound
