#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

namespace rebound {
namespace {

std::vector<std::string> effects_of_fem(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names = absent_effects(present);
  std::erase_if(names, [](const std::string& name) {
    const Effect& effect = find_effect(name);
    return !effect.to_fem || is_measurement(name) || effect.card.is_free_form ||
           effect.card.is_switch || effect.card.oscillator || effect.card.oscillator_pair;
  });
  return names;
}

std::vector<std::string> free_forms_of_fem(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names = free_forms(present, false);
  const std::vector<std::string> later = free_forms(present, true);
  names.insert(names.end(), later.begin(), later.end());
  std::erase_if(names, [](const std::string& name) {
    const Effect& effect = find_effect(name);
    return !effect.to_fem || effect.card.oscillator_pair;
  });
  return names;
}

std::vector<EffectChoice> starts_of(const EffectCard& card, double contact_time) {
  constexpr double half = 0.5;
  EffectChoice start{.name = card.name, .size = card.prior_scale, .parameters = {}};
  for (const EffectParameterCard& one : card.parameters)
    start.parameters[one.name] = one.name == card.fades_in        ? half * contact_time
                                 : one.is_left_open && one.in_fem ? one.tried.front()
                                                                  : one.default_value;
  std::vector<EffectChoice> starts{start};
  for (const double larger : {10.0, 100.0}) {
    start.size = larger * card.prior_scale;
    if (card.range.contains(start.size)) starts.push_back(start);
  }
  return starts;
}

}  // namespace

StartsOfEffects starts_of_named(const HypothesisFit& lumped) {
  const double contact_time = lumped.model->impact(lumped.values, 0).scalars.contact_time;
  StartsOfEffects starts;
  for (const std::string& name : effects_of_fem(lumped.effects))
    starts.push_back(starts_of(find_effect(name).card, contact_time));
  return starts;
}

StartsOfEffects starts_of_free_forms(const Observations& seen, const HypothesisFit& lumped) {
  StartsOfEffects starts;
  for (const std::string& name : free_forms_of_fem(lumped.effects))
    starts.push_back(starts_of_free_form(find_effect(name).card, seen, lumped));
  return starts;
}

StartsOfEffects starts_of_faults(const Observations& seen, const HypothesisFit& lumped) {
  StartsOfEffects starts;
  for (const std::string& name : absent_effects(lumped.effects)) {
    const EffectCard& card = find_effect(name).card;
    if (!is_measurement(name)) continue;
    starts.push_back(card.is_linear ? small_effects(card, seen, GridDetail::fine)
                                    : finite_effects(card, seen, GridDetail::fine));
  }
  return starts;
}

StartsOfEffects all_starts(const Observations& seen, const HypothesisFit& lumped) {
  StartsOfEffects all = starts_of_named(lumped);
  for (const StartsOfEffects& more :
       {starts_of_free_forms(seen, lumped), starts_of_faults(seen, lumped)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace rebound
