#include "comparisons/evaluation/convert/conversion_file.hpp"

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"

namespace rebound {
namespace {

Key stiffness_key() {
  return {.name = "stiffness",
          .sentence = "Hertz stiffness kappa of F = kappa x^1.5.",
          .unit = "N/m^1.5",
          .range = above(0.0)};
}

Key restitution_key() {
  return {.name = "restitution",
          .sentence = "Restitution at the impact speed.",
          .range = between(0.0, 1.0)};
}

void describe_values(Visitor& visit, Given& given) {
  switch (given.convention) {
    case Convention::law:
      visit.text({.name = "law", .sentence = "The contact law.", .allowed = law_names()},
                 given.model.law);
      visit.visit_table({.name = "parameters", .sentence = "Its parameters."}, [&](Visitor& inner) {
        describe_some_parameters(inner, given.model.law, {}, given.model.parameters);
      });
      break;
    case Convention::spring_dashpot:
      visit.number(
          {.name = "spring", .sentence = "Spring constant k.", .unit = "N/m", .range = above(0.0)},
          given.spring);
      visit.number({.name = "dashpot",
                    .sentence = "Dashpot constant d.",
                    .unit = "N.s/m",
                    .range = above(0.0)},
                   given.dashpot);
      break;
    case Convention::contact_time:
      visit.number({.name = "contact_time",
                    .sentence = "Contact time at the impact speed.",
                    .unit = "ms",
                    .range = above(0.0)},
                   given.contact_time);
      visit.number(restitution_key(), given.restitution);
      break;
    case Convention::restitution:
      visit.number(stiffness_key(), given.stiffness);
      visit.number(restitution_key(), given.restitution);
      break;
    case Convention::loss_tangent:
      visit.number(stiffness_key(), given.stiffness);
      visit.number(
          {.name = "loss_tangent",
           .sentence = "Loss tangent at angular frequency pi over the elastic contact time.",
           .range = between(0.0, 10.0)},
          given.loss_tangent);
      break;
  }
}

}  // namespace

void describe(Visitor& visit, Given& given) {
  visit.choice({.name = "convention", .sentence = "In which terms the contact is given."},
               given.convention);
  visit.cases(
      all_names<Convention>(), name_of(given.convention),
      [&](const std::string& text) { read_name(text, given.convention); },
      [&](Visitor& inner) { describe_values(inner, given); });
}

void describe(Visitor& visit, ConversionRequest& request) {
  describe_schema(visit);
  visit.number({.name = "check_speed",
                .sentence = "Speed at which the errors are taken; the impact speed if absent.",
                .presence = Presence::optional,
                .unit = "m/s",
                .range = above(0.0)},
               request.check_speed);
  visit.table({.name = "impact",
               .sentence = "Speed the conversion is made at, and the code's separation rule."},
              request.impact);
  visit.table({.name = "sphere", .sentence = "The ball."}, request.sphere);
  visit.table({.name = "given", .sentence = "What is known of the contact."}, request.given);
}

}  // namespace rebound
