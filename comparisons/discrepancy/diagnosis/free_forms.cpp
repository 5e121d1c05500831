#include "comparisons/discrepancy/diagnosis/free_forms.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

/// Largest deflection over the radius and largest speed of the shots, by the fitted model.
struct Reach {
  double deflection = 0.0;  ///< [-]
  double rate = 0.0;        ///< [m/s]
};

Reach reach_of(const Observations& seen, const HypothesisFit& fit) {
  Reach reach;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    const MeasuredImpact& shot = seen.shots[i];
    const double deflection = fit.model->impact(fit.values, i).scalars.peak_deflection;
    reach.deflection = std::max(reach.deflection, 2.0 * deflection / shot.sphere.diameter);
    reach.rate = std::max(reach.rate, shot.impact.speed);
  }
  return reach;
}

double mean_contact_time(const Observations& seen, const HypothesisFit& fit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    sum += fit.model->impact(fit.values, i).scalars.contact_time;
  return sum / static_cast<double>(seen.shots.size());
}

const Estimate* estimate_of(const HypothesisFit& fit, std::size_t k, const std::string& number) {
  const std::string name = fit.effects[k].name + (number.empty() ? "" : " " + number);
  for (const std::size_t unknown : fit.model->unknowns_of_effect(k))
    if (fit.search.estimates[unknown].name == name) return &fit.search.estimates[unknown];
  return nullptr;
}

}  // namespace

std::vector<std::string> free_forms(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects()) {
    const bool known = std::any_of(present.begin(), present.end(), [&](const EffectChoice& one) {
      return one.name == effect.card.name;
    });
    if (effect.card.is_free_form && !known) names.push_back(effect.card.name);
  }
  return names;
}

std::vector<EffectChoice> starts_of_free_form(const EffectCard& card, const Observations& seen,
                                              const HypothesisFit& fit) {
  const Reach reach = reach_of(seen, fit);
  EffectChoice start{.name = card.name, .size = card.null, .parameters = {}};
  for (const EffectParameterCard& parameter : card.parameters) {
    double& value = start.parameters[parameter.name];
    value = parameter.default_value;
    if (parameter.kind == ParameterKind::largest_deflection) value = reach.deflection;
    if (parameter.kind == ParameterKind::largest_rate) value = reach.rate;
    value = std::clamp(value, parameter.range.lowest, parameter.range.highest);
  }
  std::vector<EffectChoice> starts{start};
  for (const EffectParameterCard& parameter : card.parameters) {
    std::vector<double> places = parameter.tried;
    if (parameter.dimension == dimension::time)
      for (const double share : {0.2, 1.0}) places.push_back(share * mean_contact_time(seen, fit));
    if (!parameter.fitted || places.empty()) continue;
    // A place or a time says nothing at no size.
    start.size = 0.3 * card.prior_scale;
    starts.clear();
    for (const double place : places) {
      starts.push_back(start);
      starts.back().parameters[parameter.name] = place;
    }
  }
  return starts;
}

std::vector<EffectChoice> starts_beside_a_formula(const EffectCard& card,
                                                  const std::vector<EffectChoice>& starts) {
  std::vector<EffectChoice> all;
  for (const EffectChoice& formula : starts) {
    std::vector<EffectChoice> own{formula};
    own.front().name = card.name;
    for (const EffectParameterCard& parameter : card.parameters) {
      if (formula.parameters.contains(parameter.name)) continue;
      std::vector<EffectChoice> next;
      for (const EffectChoice& one : own)
        for (const double value : parameter.tried) {
          next.push_back(one);
          next.back().parameters[parameter.name] = value;
        }
      own = std::move(next);
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::string formula_within(const EffectCard& card) {
  if (!card.curves.empty()) return {};
  for (const Effect& effect : all_effects()) {
    const EffectCard& formula = effect.card;
    if (formula.is_free_form || formula.family != card.family || formula.parameters.empty() ||
        formula.size_dimension != card.size_dimension)
      continue;
    if (std::all_of(formula.parameters.begin(), formula.parameters.end(), [&](const auto& one) {
          return std::any_of(card.parameters.begin(), card.parameters.end(),
                             [&](const auto& own) { return own.name == one.name; });
        }))
      return formula.name;
  }
  return {};
}

std::vector<FactorBand> bands_of(const HypothesisFit& fit, std::size_t k) {
  std::vector<FactorBand> bands;
  for (const CurveCard& curve : find_effect(fit.effects[k].name).card.curves) {
    FactorBand& band = bands.emplace_back(FactorBand{.of = curve.of, .quantity = curve.quantity});
    const double reach = curve.reach.empty() ? 1.0 : fit.effects[k].parameters.at(curve.reach);
    const double nothing = curve.quantity == "factor" ? 1.0 : 0.0;
    for (const CurveCard::Point& point : curve.points) {
      const Estimate* value = estimate_of(fit, k, point.number);
      if (!value) continue;
      band.x.push_back(reach * point.place);
      const double low = nothing + point.sign * value->low;
      const double high = nothing + point.sign * value->high;
      band.factor.push_back(nothing + point.sign * value->value);
      band.low.push_back(std::min(low, high));
      band.high.push_back(std::max(low, high));
    }
  }
  return bands;
}

}  // namespace rebound
