#include "comparisons/models/effects/effect.hpp"
#include "comparisons/python/binding.hpp"
#include "lumped/laws/law_card.hpp"

namespace rebound::python {
namespace {

/// The unit of a stiffness depends on the exponent beside it: told at the typical one.
Json parameter_of(const ParameterCard& card, const ParameterValues& typical) {
  return {{"name", card.name},
          {"sentence", card.sentence},
          {"unit", unit_name(card.dimension(typical))},
          {"lowest", card.range.lowest},
          {"highest", card.range.highest},
          {"default", number_or_null(card.default_value)}};
}

Json law_of(const LawCard& card) {
  ParameterValues typical;
  for (const ParameterCard& parameter : card.parameters)
    typical[parameter.name] = parameter.default_value.value_or(parameter.typical);
  Json parameters = Json::array();
  for (const ParameterCard& parameter : card.parameters)
    parameters.push_back(parameter_of(parameter, typical));
  return {{"name", card.name},
          {"equation", card.equation},
          {"source", card.source},
          {"parameters", parameters}};
}

Json effect_of(const Effect& effect) {
  const EffectCard& card = effect.card;
  Json parameters = Json::array();
  for (const EffectParameterCard& parameter : card.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"sentence", parameter.sentence},
                          {"unit", unit_name(parameter.dimension)},
                          {"lowest", parameter.range.lowest},
                          {"highest", parameter.range.highest},
                          {"default", parameter.default_value}});
  Json acts = Json::array();
  if (effect.to_lumped) acts.push_back("lumped");
  if (effect.to_fem) acts.push_back("fem");
  if (effect.to_measurement) acts.push_back("measurement");
  return {{"name", card.name},
          {"family", name_of(card.family)},
          {"sentence", card.sentence},
          {"equation", card.equation},
          {"acts_on", acts},
          {"unit", size_unit(card)},
          {"null", card.null},
          {"lowest", card.range.lowest},
          {"highest", card.range.highest},
          {"parameters", parameters},
          {"signature", card.signature},
          {"experiment", card.experiment},
          {"source", card.source}};
}

}  // namespace

void declare_cards(py::module_& module) {
  module.def(
      "laws", [] { return to_python(list_of(all_laws(), law_of)); },
      "Contact laws: name, equation, source, parameters. Ranges are in SI; None: no limit. A unit\n"
      "that depends on an exponent is that at its usual value.");
  module.def(
      "effects", [] { return to_python(list_of(all_effects(), effect_of)); },
      "Effects that a model may lack: name, family, equation, what they act on, unit and range of\n"
      "their size, parameters, where they show, what experiment would tell. In SI.");
}

}  // namespace rebound::python
