#include "comparisons/io/toml/describe_effect.hpp"

#include <limits>

#include "comparisons/io/toml/units.hpp"

namespace rebound {

void describe(Visitor& visit, Plate& plate) {
  visit.number<&Plate::friction>(plate,
                                 {.sentence = "Coulomb friction of the contact; absent: none.",
                                  .presence = Presence::optional});
  visit.number<&Plate::stiffness>(
      plate, {.sentence = "Spring under the plate, as of a load cell; absent: the plate stands "
                          "still.",
              .presence = Presence::optional});
  visit.number<&Plate::mass>(plate,
                             {.sentence = "Mass of a plate with a stiffness; 2 kg when absent.",
                              .presence = Presence::optional},
                             plate.moves());
  visit.number<&Plate::damping_ratio>(
      plate,
      {.sentence = "Damping ratio of a plate with a stiffness; 0.02 when absent.",
       .presence = Presence::optional},
      plate.moves());
}

namespace {

void describe_numbers(Visitor& visit, EffectChoice& choice) {
  const EffectCard& card = find_effect(choice.name).card;
  visit.number({.name = "size",
                .sentence = card.sentence + " " + card.equation,
                .unit = size_unit(card),
                .range = card.range},
               choice.size);
  for (const EffectParameterCard& parameter : card.parameters) {
    double& value =
        choice.parameters.emplace(parameter.name, parameter.default_value).first->second;
    visit.number({.name = parameter.name,
                  .sentence = parameter.sentence,
                  .presence = Presence::optional,
                  .unit = unit_name(parameter.dimension),
                  .range = parameter.range},
                 value);
  }
}

}  // namespace

void describe(Visitor& visit, EffectChoice& choice) {
  const std::vector<std::string> names = effect_names();
  visit.text({.name = "name", .sentence = "The effect.", .allowed = names}, choice.name);
  if (visit.refused("name") || choice.name.empty()) return;  // it decides over the unit of the size
  visit.cases(
      names, choice.name,
      [&](const std::string& name) { choice = {.name = name, .size = 0.0, .parameters = {}}; },
      [&](Visitor& inner) { describe_numbers(inner, choice); });
}

void describe_effects(Visitor& visit, std::vector<EffectChoice>& effects) {
  visit.visit_list({.name = "effect",
                    .sentence = "A named effect added to the model; repeat for more.",
                    .presence = Presence::optional},
                   {[&] { return effects.size(); }, [&](std::size_t n) { effects.resize(n); },
                    [&](Visitor& inner, std::size_t i) {
                      EffectChoice example{
                          .name = effect_names().front(), .size = 0.0, .parameters = {}};
                      describe(inner, i < effects.size() ? effects[i] : example);
                    }});
}

}  // namespace rebound
