#include "comparisons/models/effects/effect.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>
#include <unordered_map>

#include "comparisons/models/effects/check_effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

#define REBOUND_EFFECT(name) Effect name##_effect();
#include "comparisons/models/effects/effects.inc"
#undef REBOUND_EFFECT

namespace {

std::string path_of(std::size_t index) {
  return "model.effect[" + std::to_string(index) + "]";
}

/// Errors of one effect's own requirement, with the place in the list added.
template <class Record>
void apply_at(void (*apply)(const EffectChoice&, Record&), const EffectChoice& choice,
              Record& record, std::size_t index) {
  try {
    apply(choice, record);
  } catch (const Error& error) {
    ErrorLocation location = error.location();
    if (location.key.empty()) location.key = path_of(index) + ".name";
    throw Error(error.code(), error.what(), location);
  }
}

[[noreturn]] void refuse_form(const EffectChoice& choice, const Effect& effect,
                              const std::string& tier, std::size_t index) {
  const bool measurement = effect.card.kind == EffectKind::measurement;
  throw Error(ExitCode::bad_input,
              measurement ? "'" + choice.name +
                                "' is a fault of the measurement and changes data, not the "
                                "impact: `rebound synthesize` applies it"
                          : "'" + choice.name + "' has no form in the " + tier + " tier",
              {.key = path_of(index) + ".name",
               .value = choice.name,
               .allowed = "effects with a form in this tier"});
}

/// A number that the FE form does not have would pass unseen.
void refuse_numbers_of_lumped_form(const EffectCard& card, const EffectChoice& choice,
                                   std::size_t index) {
  for (const EffectParameterCard& one : card.parameters) {
    const double value = choice.parameters.at(one.name);
    const bool measured = one.kind == ParameterKind::largest_deflection;  // that of another model
    if (!one.in_fem && !measured && value != one.default_value)
      throw Error(ExitCode::bad_input,
                  "the FE form of '" + card.name + "' has no number '" + one.name + "'",
                  {.key = path_of(index) + "." + one.name,
                   .value = number_text(value),
                   .allowed = number_text(one.default_value) + ", or left out"});
  }
}

/// Is there anything of it? The size of a free form is one of its numbers: the others may act where
/// it is zero.
bool acts(const EffectCard& card, const EffectChoice& choice) {
  return choice.size != card.null ||
         (card.is_free_form && std::any_of(card.parameters.begin(), card.parameters.end(),
                                           [&](const EffectParameterCard& one) {
                                             return choice.parameters.at(one.name) !=
                                                    one.default_value;
                                           }));
}

template <class Record>
void apply_all(const std::vector<EffectChoice>& effects, Record& record,
               void (*Effect::*form)(const EffectChoice&, Record&), const std::string& tier) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Effect& effect = find_effect(effects[i].name);
    const EffectChoice choice = checked_choice(effect.card, effects[i], path_of(i));
    if (!seen.insert(choice.name).second)
      throw Error(ExitCode::bad_input, "the effect '" + choice.name + "' is given twice",
                  {.key = path_of(i) + ".name", .value = choice.name, .allowed = "once"});
    if constexpr (std::is_same_v<Record, FemProblem>)
      refuse_numbers_of_lumped_form(effect.card, choice, i);
    const auto apply = effect.*form;
    if (!apply) {
      if (tier.empty()) continue;  // the measurement passes over what is physical
      refuse_form(choice, effect, tier, i);
    }
    if (acts(effect.card, choice)) apply_at(apply, choice, record, i);
  }
}

}  // namespace

const std::vector<Effect>& all_effects() {
#define REBOUND_EFFECT(name) name##_effect(),
  static const std::vector<Effect> list = {
#include "comparisons/models/effects/effects.inc"
  };
#undef REBOUND_EFFECT
  return list;
}

bool acts_on_one_shot(const EffectCard& card) {
  return std::any_of(card.parameters.begin(), card.parameters.end(),
                     [](const auto& one) { return one.kind == ParameterKind::shot; });
}

bool makes_variants(const EffectParameterCard& parameter) {
  return parameter.kind != ParameterKind::shot && !parameter.tried.empty() &&
         (!parameter.fitted || parameter.is_left_open);
}

bool is_unknown(const EffectParameterCard& parameter, bool of_fem, const EffectChoice& choice) {
  if (!parameter.fitted || (of_fem && !parameter.in_fem)) return false;
  if (!parameter.is_left_open) return true;
  const auto given = choice.parameters.find(parameter.name);
  return given != choice.parameters.end() && given->second != parameter.default_value;
}

double share_next_to_null(const EffectCard& card) {
  constexpr double of_a_logarithm = 0.01, usual = 1e-4;
  return has_logarithmic_size(card) ? of_a_logarithm : usual;
}

std::string effect_behind(const std::string& name) {
  const std::string& effect = find_effect(name).card.free_form_of;
  return effect.empty() ? name : effect;
}

EffectChoice form_in_fem(EffectChoice choice) {
  for (const EffectParameterCard& one : find_effect(choice.name).card.parameters)
    if (!one.in_fem && (!one.fitted || one.is_left_open)) choice.parameters.erase(one.name);
  return choice;
}

bool has_logarithmic_size(const EffectCard& card) {
  return card.oscillator ||
         (!card.contains.empty() && has_logarithmic_size(find_effect(card.contains).card));
}

std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects()) names.push_back(effect.card.name);
  return names;
}

std::string size_unit(const EffectCard& card) {
  return card.size_dimension == dimension::energy_per_area ? "J/m^2"
                                                           : unit_name(card.size_dimension);
}

const Effect& find_effect(const std::string& name) {
  // Searches ask a million times.
  static const std::unordered_map<std::string, const Effect*> by_name = [] {
    std::unordered_map<std::string, const Effect*> all;
    for (const Effect& effect : all_effects()) all.emplace(effect.card.name, &effect);
    return all;
  }();
  if (const auto found = by_name.find(name); found != by_name.end()) return *found->second;
  std::string names;
  for (const Effect& effect : all_effects())
    names += (names.empty() ? "" : ", ") + effect.card.name;
  throw Error(ExitCode::bad_input, "unknown effect '" + name + "'",
              {.key = "model.effect", .value = name, .allowed = names});
}

std::vector<EffectChoice> effects_of_ball(std::vector<EffectChoice> effects, std::size_t ball) {
  for (EffectChoice& one : effects) {
    if (!one.size_of_balls.empty()) one.size = one.size_of_balls[ball];
    one.size_of_balls.clear();
  }
  return effects;
}

bool is_measurement(const std::string& name) {
  return find_effect(name).card.kind == EffectKind::measurement;
}

void apply_effects(const std::vector<EffectChoice>& effects, LumpedProblem& problem) {
  apply_all(effects, problem, &Effect::to_lumped, "lumped");
}

void apply_effects(const std::vector<EffectChoice>& effects, FemProblem& problem) {
  apply_all(effects, problem, &Effect::to_fem, "FE");
}

void apply_effects(const std::vector<EffectChoice>& effects, MeasurementChain& chain) {
  apply_all(effects, chain, &Effect::to_measurement, "");
}

std::vector<EffectChoice> physical_effects(const std::vector<EffectChoice>& effects) {
  std::vector<EffectChoice> physical;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(physical),
               [](const EffectChoice& choice) { return !is_measurement(choice.name); });
  return physical;
}

bool hold_a_fault(const std::vector<EffectChoice>& effects) {
  return std::any_of(effects.begin(), effects.end(),
                     [](const EffectChoice& choice) { return is_measurement(choice.name); });
}

}  // namespace rebound
