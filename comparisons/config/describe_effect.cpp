#include "comparisons/config/describe_effect.hpp"

#include <limits>

#include "comparisons/config/units.hpp"

namespace rebound {

void describe(Visitor& visit, Plate& plate) {
  const auto given = [](bool is_given, double value) {
    return is_given ? std::optional(value) : std::nullopt;
  };
  auto stiffness = given(plate.moves(), plate.stiffness);
  auto mass = given(plate.moves(), plate.mass);
  auto damping_ratio = given(plate.moves(), plate.damping_ratio);
  auto friction = given(plate.friction != 0.0, plate.friction);
  const Plate defaults;
  visit.number({.name = "friction",
                .sentence = "Coulomb friction of the contact; absent: none.",
                .presence = Presence::optional,
                .range = from_to(0.0, 5.0)},
               friction);
  visit.number({.name = "stiffness",
                .sentence = "Spring under the plate, as of a load cell; absent: the plate stands "
                            "still.",
                .presence = Presence::optional,
                .unit = "MN/m",
                .range = above(0.0)},
               stiffness);
  visit.number({.name = "mass",
                .sentence = "Mass of a plate with a stiffness; 2 kg when absent.",
                .presence = Presence::optional,
                .unit = "kg",
                .range = above(0.0)},
               mass);
  visit.number({.name = "damping_ratio",
                .sentence = "Damping ratio of a plate with a stiffness; 0.02 when absent.",
                .presence = Presence::optional,
                .range = from_to(0.0, 10.0)},
               damping_ratio);
  plate = {.stiffness = stiffness.value_or(defaults.stiffness),
           .mass = mass.value_or(defaults.mass),
           .damping_ratio = damping_ratio.value_or(defaults.damping_ratio),
           .friction = friction.value_or(defaults.friction)};
}

std::string size_unit(const EffectCard& card) {
  return card.size_dimension == dimension::energy_per_area ? "J/m^2" : unit_name(card.size_dimension);
}

namespace {

void describe_numbers(Visitor& visit, EffectChoice& choice) {
  const EffectCard& card = find_effect(choice.name).card;
  visit.number({.name = "size",
                .sentence = card.sentence + " " + card.equation,
                .unit = size_unit(card),
                .range = from_to(card.lowest, card.highest)},
               choice.size);
  for (const EffectParameterCard& parameter : card.parameters) {
    double& value =
        choice.parameters.emplace(parameter.name, parameter.default_value).first->second;
    visit.number({.name = parameter.name,
                  .sentence = parameter.sentence,
                  .presence = Presence::optional,
                  .unit = unit_name(parameter.dimension),
                  .range = from_to(parameter.lowest, parameter.highest)},
                 value);
  }
}

}  // namespace

void describe(Visitor& visit, EffectChoice& choice) {
  const std::vector<std::string> names = effect_names();
  visit.text({.name = "name", .sentence = "The effect.", .allowed = names}, choice.name);
  if (choice.name.empty())  // the name decides over the unit of the size
    return visit.not_available("size", "an effect needs its name beside its size");
  visit.cases(
      names, choice.name,
      [&](const std::string& name) { choice = {.name = name, .size = 0.0, .parameters = {}}; },
      [&](Visitor& inner) { describe_numbers(inner, choice); });
}

void describe_effects(Visitor& visit, std::vector<EffectChoice>& effects) {
  visit.visit_list(
      {.name = "effect",
       .sentence = "A named effect added to the model; repeat for more.",
       .presence = Presence::optional},
      {[&] { return effects.size(); }, [&](std::size_t n) { effects.resize(n); },
       [&](Visitor& inner, std::size_t i) {
         EffectChoice example{.name = effect_names().front(), .size = 0.0, .parameters = {}};
         describe(inner, i < effects.size() ? effects[i] : example);
       }});
}

}  // namespace rebound
