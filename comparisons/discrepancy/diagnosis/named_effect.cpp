#include "comparisons/discrepancy/diagnosis/named_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

constexpr double next_to_null = 0.011;  // of the prior scale: searches keep a hundredth off

NumberWithInterval with_interval(const HypothesisFit& fit, std::size_t unknown,
                                 const std::string& name, bool logarithmic) {
  const Estimate& e = fit.search.estimates[unknown];
  const auto back = [&](double x) { return logarithmic ? std::exp(x) : x; };
  return {.name = name, .value = back(e.value), .low = back(e.low), .high = back(e.high)};
}

/// A number that is free but looked for at one value only, such as a damping ratio: data need not
/// determine it for its effect to have a name.
bool is_secondary(const EffectCard& card, const std::string& unknown) {
  return std::any_of(card.parameters.begin(), card.parameters.end(),
                     [&](const EffectParameterCard& one) {
                       return card.name + " " + one.name == unknown && one.tried.size() == 1;
                     });
}

std::string weakness(const Estimate& estimate) {
  if (estimate.identifiability == Identifiability::not_identifiable)
    return "not determined by the data";
  if (estimate.identifiability == Identifiability::at_bound) return "at a bound of the search";
  return {};
}

}  // namespace

NamedEffect named_effect(const HypothesisFit& fit, std::size_t k) {
  const EffectChoice& choice = fit.effects[k];
  const Effect& effect = find_effect(choice.name);
  NamedEffect result{
      .effect = choice,
      .size = {.name = choice.name, .value = choice.size, .low = choice.size, .high = choice.size},
      .parameters = {}};
  if (!effect.to_fem) result.fem = "no-form";
  if (!effect.to_lumped) result.lumped = "no-form";
  const auto& unknowns = fit.model->unknowns_of_effect(k);
  if (unknowns.empty()) return result;
  result.size = with_interval(fit, unknowns[0], choice.name, false);
  std::size_t next = 1;
  for (const auto& parameter : effect.card.parameters)
    if (parameter.fitted)
      result.parameters.push_back(with_interval(fit, unknowns[next++], parameter.name,
                                                parameter.kind == ParameterKind::logarithmic));
    else if (parameter.kind == ParameterKind::shot) {
      const double shot = choice.parameters.at(parameter.name);
      result.parameters.push_back({parameter.name, shot, shot, shot});
    }
  return result;
}

std::string weak_number_of(const HypothesisFit& fit, std::size_t k) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  const auto& unknowns = fit.model->unknowns_of_effect(k);
  for (const std::size_t unknown : unknowns) {
    const Estimate& estimate = fit.search.estimates[unknown];
    if (is_secondary(card, estimate.name)) continue;
    if (const std::string why = weakness(estimate); !why.empty())
      return fmt::format("{} is {}", estimate.name, why);
  }
  if (unknowns.empty() || !std::isfinite(card.null)) return {};
  const Estimate& size = fit.search.estimates[unknowns[0]];
  const double slack = next_to_null * card.prior_scale;
  if (size.low - slack <= card.null && card.null <= size.high + slack)
    return fmt::format("the size {:.3g} [{:.3g}, {:.3g}] may as well be that of no effect",
                       size.value, size.low, size.high);
  return {};
}

}  // namespace rebound
