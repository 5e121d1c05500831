#include "comparisons/io/toml/describe_lumped.hpp"

#include <algorithm>

#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/units.hpp"
#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/law_card.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// `values` already holds the parameters that set the dimension of this one.
Key key_of(const ParameterCard& card, const ParameterValues& values) {
  return {.name = card.name,
          .sentence = card.sentence,
          .presence = card.default_value ? Presence::optional : Presence::required,
          .unit = unit_name(card.dimension(values)),
          .range = card.range};
}

/// Does the dimension of one parameter follow from the value of another, as that of a stiffness
/// from its exponent?
bool follows(const ParameterCard& card, const std::string& other, const LawCard& law) {
  ParameterValues values;
  for (const ParameterCard& one : law.parameters) values[one.name] = one.typical;
  const Dimension before = card.dimension(values);
  values[other] += 1.0;
  return !same_dimension(before, card.dimension(values));
}

/// Is the unit of a parameter unknown, since what sets it was refused?
bool hangs_on_refused(Visitor& visit, const LawCard& law, const ParameterCard& card) {
  // A reader that says yes holds the table undecided: it is asked of what the unit follows alone.
  return std::any_of(law.parameters.begin(), law.parameters.end(), [&](const ParameterCard& one) {
    return follows(card, one.name, law) && visit.refused(one.name);
  });
}

void visit_parameter(Visitor& visit, const Key& key, std::optional<double> otherwise,
                     ParameterValues& values) {
  const auto found = values.find(key.name);
  std::optional<double> value = found != values.end() ? found->second : otherwise;
  visit.visit_number(key, value);
  if (value) values[key.name] = *value;
}

void describe_parameters(Visitor& visit, LumpedModel& model) {
  const LawCard& law = find_law(model.law);
  for (const ParameterCard& card : law.parameters) {
    if (hangs_on_refused(visit, law, card)) continue;
    Key key = key_of(card, model.parameters);
    if (card.name == law.damping_parameter) {
      key.presence = Presence::optional;
      key.sentence += " Or give restitution and damping_formula.";
    }
    visit_parameter(visit, key, card.default_value, model.parameters);
  }
}

/// Any of the law's parameters may be given anew at a speed; units follow
/// from the model's own values where the speed gives no other.
void describe_at_speed(Visitor& visit, LumpedModel& model, ParametersAtSpeed& at) {
  visit.number<&ParametersAtSpeed::speed>(
      at, {.sentence = "Approach speed these parameters belong to."});
  describe_some_parameters(visit, model.law, model.parameters, at.parameters);
}

}  // namespace

void describe_some_parameters(Visitor& visit, std::string& law, const ParameterValues& known,
                              ParameterValues& values) {
  visit.cases(
      law_names(), law, [&](const std::string& name) { law = name; },
      [&](Visitor& inner) {
        ParameterValues seen = known;
        for (const ParameterCard& card : find_law(law).parameters) {
          if (hangs_on_refused(inner, find_law(law), card)) continue;
          Key key = key_of(card, seen);
          key.presence = Presence::optional;
          visit_parameter(inner, key, std::nullopt, values);
          if (values.contains(card.name)) seen[card.name] = values.at(card.name);
        }
      });
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawCard& card : all_laws()) names.push_back(card.name);
  return names;
}

std::vector<std::string> formula_names() {
  std::vector<std::string> names;
  for (const DampingFormula& formula : damping_formulas()) names.push_back(formula.name);
  return names;
}

void describe(Visitor& visit, LumpedControls& controls) {
  visit.number<&LumpedControls::relative_tolerance>(
      controls, {.sentence = "Accuracy asked of the integrator.", .presence = Presence::optional});
  visit.number<&LumpedControls::samples>(
      controls, {.sentence = "Equally spaced samples of the trace over the contact.",
                 .presence = Presence::optional});
}

void describe_lumped_model(Visitor& visit, LumpedModel& model) {
  std::string tier = "lumped";
  visit.text({.name = "tier", .sentence = "The tier this file is for.", .allowed = {"lumped"}},
             tier);
  if (visit.refused("tier")) return;  // a model of another kind
  visit.text({.name = "law", .sentence = "The contact law.", .allowed = law_names()}, model.law);
  visit.number<&LumpedModel::restitution>(
      model, {.sentence = "Restitution at the impact speed that sets the damping.",
              .presence = Presence::optional});
  visit.text({.name = "damping_formula",
              .sentence = "How the restitution is turned into damping.",
              .presence = Presence::optional,
              .allowed = formula_names()},
             model.damping_formula);
  visit.cases(
      law_names(), model.law,
      [&](const std::string& law) {
        model.law = law;
        model.parameters.clear();
      },
      [&](Visitor& inner) { describe_parameters(inner, model); });
  visit.visit_list(
      {.name = "at_speed",
       .sentence = "Parameters that were fitted speed by speed; repeat for more.",
       .presence = Presence::optional},
      {[&] { return model.at_speed.size(); }, [&](std::size_t n) { model.at_speed.resize(n); },
       [&](Visitor& inner, std::size_t i) {
         ParametersAtSpeed example;
         describe_at_speed(inner, model, i < model.at_speed.size() ? model.at_speed[i] : example);
       }});
  visit.table({.name = "plate",
               .sentence = "What the ball hits; absent: rigid. Friction has no lumped form.",
               .presence = Presence::optional},
              model.mechanisms.plate);
}

void describe(Visitor& visit, LumpedImpactFile& file) {
  LumpedProblem& problem = file.problem;
  describe_schema(visit);
  visit.table({.name = "impact", .sentence = "Normal impact on a plate at rest, no spin."},
              problem.impact);
  visit.table({.name = "sphere", .sentence = "The ball."}, problem.sphere);
  visit.visit_table({.name = "model", .sentence = "The contact law and its numbers."},
                    [&](Visitor& inner) {
                      describe_lumped_model(inner, problem.model);
                      describe_effects(inner, file.effects);
                    });
  visit.table(
      {.name = "controls", .sentence = "Accuracy and sampling.", .presence = Presence::optional},
      problem.controls);
}

void describe(Visitor& visit, LumpedProblem& problem) {
  Mechanisms beside_plate = problem.model.mechanisms;
  beside_plate.plate = {};
  if (beside_plate.act() || problem.model.exact_damping_share != 0.0)
    throw Error(ExitCode::bad_input,
                "a file names effects, not mechanisms: write the impact file this problem was "
                "made from");
  LumpedImpactFile file{.problem = problem, .effects = {}};
  describe(visit, file);
  problem = file.problem;
}

}  // namespace rebound
