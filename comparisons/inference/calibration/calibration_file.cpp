#include "comparisons/inference/calibration/calibration_file.hpp"

#include <utility>

#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"

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
  visit.texts({.name = "per_speed",
               .sentence = "Parameters that have a value of their own at each speed, e.g. "
                           "[\"damping\"].",
               .presence = Presence::optional},
              request.per_speed);
  visit.visit_table(
      {.name = "fixed",
       .sentence = "Parameters that are held at a value.",
       .presence = Presence::optional},
      [&](Visitor& inner) { describe_some_parameters(inner, request.law, {}, request.fixed); });
}

void describe(Visitor& visit, ReferenceFolder& reference) {
  visit.text({.name = "folder",
              .sentence = "A data-set folder, or a folder written by `lumped` or `fem --out`; "
                          "relative to this file."},
             reference.folder);
}

void describe(Visitor& visit, Nuisances& nuisances) {
  for (const NuisanceKind& kind : all_nuisances())
    if (!kind.asked.sentence.empty())
      visit.number({.name = kind.name,
                    .sentence = kind.asked.sentence,
                    .presence = Presence::optional,
                    .unit = kind.asked.shown_unit,
                    .range = kind.asked.range},
                   nuisances.deviation[kind.name]);
}

void describe_search(Visitor& visit, CalibrationControls& controls) {
  visit.whole({.name = "starts",
               .sentence = "Starting points of the search; the first comes from the traces.",
               .presence = Presence::optional,
               .range = from_to(1.0, 1000.0)},
              controls.starts);
  visit.whole({.name = "seed",
               .sentence = "Seed of the further starting points.",
               .presence = Presence::optional,
               .range = at_least(0.0)},
              controls.seed);
  visit.number({.name = "confidence",
                .sentence = "Confidence of the intervals.",
                .presence = Presence::optional,
                .range = between(0.0, 1.0)},
               controls.confidence);
  visit.choice({.name = "loss",
                .sentence = "Loss of a single residual; the robust ones keep wrong data "
                            "from deciding.",
                .presence = Presence::optional},
               controls.loss);
  visit.number({.name = "loss_scale",
                .sentence = "Where a robust loss bends, in standard deviations of the noise.",
                .presence = Presence::optional,
                .range = above(0.0)},
               controls.loss_scale);
  visit.choice({.name = "profiles",
                .sentence = "Likelihood-ratio intervals beside the linearised ones.",
                .presence = Presence::optional},
               controls.profiles);
}

void describe(Visitor& visit, CalibrationFile& file) {
  describe_schema(visit);
  describe_law_request(visit, file.request);
  visit.choice(
      {.name = "observable",
       .sentence = "The curve that is fitted; or scalars: what data sets without records state.",
       .presence = Presence::optional},
      file.options.observable);
  visit.choice(
      {.name = "weighting",
       .sentence = "Where the force noise is unknown: every newton counts the same, or every "
                   "trace does.",
       .presence = Presence::optional},
      file.options.weighting);
  visit.number({.name = "tip_margin",
                .sentence = "Share of the largest deflection whose samples are left out.",
                .presence = Presence::optional,
                .range = from_to(0.0, 0.5)},
               file.options.tip_margin);
  describe_search(visit, file.options.controls);
  visit.table({.name = "nuisance",
               .sentence = "What the instrument may have got wrong: standard deviations of priors.",
               .presence = Presence::optional},
              file.options.nuisances);
  visit.list({.name = "reference", .sentence = "What is calibrated to; repeat for more."},
             file.references);
}

std::vector<MeasuredImpact> references_of(const Document& document, const CalibrationFile& file) {
  const auto read =
      file.options.observable == Observable::scalars ? read_scalar_references : read_references;
  std::vector<MeasuredImpact> shots;
  for (const ReferenceFolder& reference : file.references)
    for (MeasuredImpact& found : read(document.folder() / reference.folder))
      shots.push_back(std::move(found));
  return shots;
}

}  // namespace rebound
