#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"

#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

namespace rebound {

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

std::vector<EffectChoice> starts_in_fem(const EffectCard& card, double contact_time) {
  constexpr double half = 0.5;
  EffectChoice start{.name = card.name, .size = card.prior_scale, .parameters = {}};
  for (const EffectParameterCard& one : card.parameters)
    start.parameters[one.name] = one.name == card.fades_in ? half * contact_time
                                 : one.is_left_open        ? one.tried.front()
                                                           : one.default_value;
  std::vector<EffectChoice> starts{start};
  for (const double larger : {10.0, 100.0}) {
    start.size = larger * card.prior_scale;
    if (card.range.contains(start.size)) starts.push_back(start);
  }
  return starts;
}

}  // namespace rebound
