#include "comparisons/inference/calibration/effect_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rebound {
namespace {

constexpr double parameter_reach = 100.0;  // a factor either way of where a parameter starts

CalibrationParameter logarithm_of_size(const EffectCard& card, double start) {
  const double off_null = start > 0.0 ? start : card.prior_scale;
  return {.name = card.name,
          .unit = "ln SI",
          .start = std::log(off_null),
          .lowest = std::log(share_next_to_null(card) * off_null),
          .highest = std::log(card.range.highest),
          .scale = 1.0};
}

CalibrationParameter size_of(const EffectCard& card, double start, bool of_fem) {
  const Range& range = card.range_of_size(of_fem);
  if (has_logarithmic_size(card)) return logarithm_of_size(card, start);
  // At nothing the other numbers of an effect say nothing: searches keep off a one-sided null.
  const double least = card.null <= range.lowest
                           ? card.null + share_next_to_null(card) * card.prior_scale
                           : range.lowest;
  return {.name = card.name,
          .unit = "SI",
          .start = std::max(start, least),
          .lowest = least,
          .highest = range.highest,
          .scale = card.prior_scale};
}

double start_of(const EffectParameterCard& parameter, const EffectChoice& choice) {
  const auto given = choice.parameters.find(parameter.name);
  return given != choice.parameters.end() ? given->second : parameter.default_value;
}

CalibrationParameter linear_of(const EffectCard& card, const EffectParameterCard& parameter,
                               const EffectChoice& choice) {
  return {.name = card.name + " " + parameter.name,
          .unit = "SI",
          .start = start_of(parameter, choice),
          .lowest = parameter.range.lowest,
          .highest = std::min(parameter.range.highest, parameter.most_fitted),
          .scale = parameter.scale,
          .prior = parameter.prior_deviation > 0.0
                       ? std::optional(Prior{parameter.default_value, parameter.prior_deviation})
                       : std::nullopt};
}

CalibrationParameter logarithm_of(const EffectCard& card, const EffectParameterCard& parameter,
                                  const EffectChoice& choice) {
  // About the start and not the default: a plate under a small ball is no plate of two kilograms.
  const double start = start_of(parameter, choice);
  const double lowest = std::max(parameter.range.lowest, start / parameter_reach);
  const double highest =
      std::min({parameter.range.highest, parameter.most_fitted, start * parameter_reach});
  return {.name = card.name + " " + parameter.name,
          .unit = "ln SI",
          .start = std::log(start),
          .lowest = std::log(lowest),
          .highest = std::log(highest),
          .scale = 1.0};
}

}  // namespace

EffectUnknowns::EffectUnknowns(std::vector<EffectChoice> effects, bool of_fem,
                               std::vector<CalibrationParameter>& unknowns)
    : effects_(std::move(effects)), of_fem_(of_fem) {
  for (const EffectChoice& choice : effects_) {
    const EffectCard& card = find_effect(choice.name).card;
    auto& own = places_.emplace_back();
    const auto add = [&](const CalibrationParameter& unknown) {
      own.push_back(unknowns.size());
      unknowns.push_back(unknown);
    };
    sizes_.push_back(0);
    if (card.is_switch) continue;
    sizes_.back() = std::max<std::size_t>(1, choice.size_of_balls.size());
    if (choice.size_of_balls.empty()) add(size_of(card, choice.size, of_fem_));
    for (std::size_t ball = 0; ball < choice.size_of_balls.size(); ++ball) {
      CalibrationParameter own = size_of(card, choice.size_of_balls[ball], of_fem_);
      own.name += " of ball " + std::to_string(ball + 1);
      add(own);
    }
    for (const EffectParameterCard& parameter : card.parameters)
      if (is_unknown(parameter, of_fem_, choice))
        add(parameter.kind == ParameterKind::linear ? linear_of(card, parameter, choice)
                                                    : logarithm_of(card, parameter, choice));
  }
}

std::vector<std::size_t> EffectUnknowns::places_of_ball(std::size_t k, std::size_t ball) const {
  if (sizes_[k] < 2) return places_[k];
  std::vector<std::size_t> own{places_[k][ball]};
  own.insert(own.end(), places_[k].begin() + static_cast<std::ptrdiff_t>(sizes_[k]),
             places_[k].end());
  return own;
}

std::vector<EffectChoice> EffectUnknowns::at(const std::vector<double>& values) const {
  std::vector<EffectChoice> effects = effects_;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const auto& own = places_[k];
    if (own.empty()) continue;
    const EffectCard& card = find_effect(effects[k].name).card;
    const auto size_at = [&](std::size_t place) {
      const double value = values[own[place]];
      return has_logarithmic_size(card)
                 ? std::clamp(std::exp(value), card.range.lowest, card.range.highest)
                 : value;
    };
    effects[k].size = size_at(0);
    for (std::size_t ball = 0; ball < effects[k].size_of_balls.size(); ++ball)
      effects[k].size_of_balls[ball] = size_at(ball);
    std::size_t next = sizes_[k];
    for (const auto& parameter : card.parameters)
      if (is_unknown(parameter, of_fem_, effects_[k])) {
        const double value = values[own[next++]];
        effects[k].parameters[parameter.name] =
            std::clamp(parameter.kind == ParameterKind::linear ? value : std::exp(value),
                       parameter.range.lowest, parameter.range.highest);
      }
  }
  return effects;
}

}  // namespace rebound
