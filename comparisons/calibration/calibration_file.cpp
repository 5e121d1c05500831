#include "comparisons/calibration/calibration_file.hpp"

#include "comparisons/config/describe_impact.hpp"
#include "comparisons/config/describe_lumped.hpp"

namespace rebound {

void describe_law_request(Visitor& visit, LawRequest& request) {
  visit.text({.name = "law", .sentence = "The contact law.", .allowed = law_names()}, request.law);
  visit.text({.name = "damping_formula",
              .sentence = "Fit the stiffness alone and take each trace's damping from its "
                          "restitution by this formula (hunt-crossley, equivalent-kelvin-voigt); "
                          "the seed paper's own is \"hunt-crossley\".",
              .presence = Presence::optional,
              .allowed = formula_names()},
             request.damping_formula);
  visit.texts({.name = "free",
               .sentence = "Parameters with a default that are fitted too, e.g. [\"exponent\"].",
               .presence = Presence::optional},
              request.free);
  visit.visit_table({.name = "fixed",
                     .sentence = "Parameters that are held at a value.",
                     .presence = Presence::optional},
                    [&](Visitor& inner) {
                      describe_some_parameters(inner, request.law, {}, request.fixed);
                    });
}

void describe(Visitor& visit, ReferenceFolder& reference) {
  visit.text({.name = "folder",
              .sentence = "A data-set folder, or a folder written by `lumped` or `fem --out`; "
                          "relative to this file."},
             reference.folder);
}

void describe(Visitor& visit, CalibrationFile& file) {
  describe_schema(visit);
  describe_law_request(visit, file.request);
  visit.choice<Weighting>(
      {.name = "weighting",
       .sentence = "Where the force noise is unknown: every newton counts the same, or every "
                   "trace does.",
       .presence = Presence::optional},
      {{"absolute", Weighting::absolute}, {"of-peak", Weighting::of_peak}},
      file.options.weighting);
  visit.number({.name = "tip_margin",
                .sentence = "Share of the largest deflection whose samples are left out.",
                .presence = Presence::optional,
                .range = from_to(0.0, 0.5)},
               file.options.tip_margin);
  visit.whole({.name = "starts",
               .sentence = "Starting points of the search; the first comes from the traces.",
               .presence = Presence::optional,
               .range = from_to(1.0, 1000.0)},
              file.options.controls.starts);
  visit.whole({.name = "seed",
               .sentence = "Seed of the further starting points.",
               .presence = Presence::optional,
               .range = at_least(0.0)},
              file.options.controls.seed);
  visit.number({.name = "confidence",
                .sentence = "Confidence of the intervals.",
                .presence = Presence::optional,
                .range = between(0.0, 1.0)},
               file.options.controls.confidence);
  visit.list({.name = "reference", .sentence = "What is calibrated to; repeat for more."},
             file.references);
}

}  // namespace rebound
