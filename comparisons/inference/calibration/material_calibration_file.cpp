#include "comparisons/inference/calibration/material_calibration_file.hpp"

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {

void describe(Visitor& visit, MaterialCalibrationFile& file) {
  describe_schema(visit);
  std::string tier = "fem";
  visit.text(
      {.name = "tier", .sentence = "Numbers of an FE material, not of a law.", .allowed = {"fem"}},
      tier);
  visit.text({.name = "model",
              .sentence = "FE impact file: cells, and the material that the search starts from; "
                          "relative to this file."},
             file.model);
  visit.texts({.name = "free",
               .sentence = "Numbers that are fitted: \"youngs_modulus\", \"branch[0].ratio\", "
                           "\"branch[0].relaxation_time\", and so on."},
              file.free);
  visit.texts({.name = "folders",
               .sentence = "Data sets, or results of `lumped` or `fem --out`; relative to this "
                           "file. Every shot is fitted."},
              file.folders);
  visit.choice({.name = "observable",
                .sentence = "What is fitted: restitution and contact time, or "
                            "the force over time where there are traces.",
                .presence = Presence::optional},
               file.observable);
  visit.number({.name = "force_uncertainty",
                .sentence = "Standard deviation of a force that states none, over the peak.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.force_uncertainty);
  visit.number({.name = "reach",
                .sentence = "Bounds of a number: this many times its start, either way.",
                .presence = Presence::optional,
                .range = between(1.0, 1e4)},
               file.reach);
  describe_search(visit, file.controls);
  visit.number({.name = "restitution_uncertainty",
                .sentence = "Standard deviation of a restitution that states none.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.restitution_uncertainty);
  visit.number({.name = "contact_time_uncertainty",
                .sentence = "Standard deviation of a contact time that states none, as a share.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.contact_time_uncertainty);
}

}  // namespace rebound
