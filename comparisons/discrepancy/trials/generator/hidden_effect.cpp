#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

namespace trials {

bool HiddenEffect::in_registry() const {
  return form->in_registry && (!form->only_at_largest || size == form->largest);
}

void apply(const HiddenEffect& effect, const Scales& scales, HiddenWorld& world) {
  if (effect.size != 0.0) effect.form->apply(effect.size, effect.parameters, scales, world);
}

const std::vector<EffectForm>& all_forms() {
  static const std::vector<EffectForm> forms = [] {
    std::vector<EffectForm> all;
    for (const auto& family :
         {elastic_forms(), rate_forms(), memory_forms(), history_forms(), surface_forms(),
          dynamics_forms(), measurement_forms(), out_of_family_forms()})
      all.insert(all.end(), family.begin(), family.end());
    return all;
  }();
  return forms;
}

std::vector<const EffectForm*> forms_of(const std::string& family) {
  std::vector<const EffectForm*> found;
  for (const EffectForm& form : all_forms())
    if (form.family == family) found.push_back(&form);
  return found;
}

}  // namespace trials
